#pragma once

#include <complex>
#include <vector>

namespace cleave::analytic {

/// The roots with Im > 0, in ascending order of |root|, of c[0] + c[1] x + ... + c[n] x^n = 0, c[n] != 0: all roots at once by Durand and
/// Kerner's iteration (Kerner 1966, Numer. Math. 8, 290). Nearly equal roots lose half of the digits.
std::vector<std::complex<double>> upper_roots(const std::vector<double>& coefficients);

}  // namespace cleave::analytic
