#pragma once

#include <complex>

namespace cleave::contact {

// What the pressure's shape does to Stroh's sum over directions: the source 1/s of a point force, s = (m . x + p z)/a, becomes, for
// Hertz's pressure of the same force (its projection onto the direction m is (3/4)(1 - s^2) on -1 < s < 1),
//
//   g(s) = (3/4) [(1 - s^2) ln((s+1)/(s-1)) + 2 s] = 3 sum over k >= 0 of s^-(2k+1) / ((2k+1)(2k+3)),   Im s >= 0.

inline constexpr int patch_series_terms = 10;

/// |s|^2 from which on the series is exact to 1e-11.
inline constexpr double patch_series_from = 9;

/// Factor of s^-(2k+1).
constexpr double patch_series_factor(int k) { return 3.0 / ((2 * k + 1) * (2 * k + 3)); }

/// g(s).
std::complex<double> patch_kernel(const std::complex<double>& s);

/// dg/ds; logarithmically infinite at s = +-1, the rim of the patch.
std::complex<double> patch_kernel_derivative(const std::complex<double>& s);

}  // namespace cleave::contact
