#pragma once

#include "validation/analytic/barnett_lothe.hpp"

#include <cstdint>
#include <random>
#include <string>

namespace cleave::validation {

/// Numbers that are the same on every machine: bits of an engine that the standard fixes, and + - * / sqrt only, which IEEE 754 fixes.
class SeededNumbers {
public:
    explicit SeededNumbers(std::uint64_t seed) : engine_(seed) {}
    /// In [0, 1).
    double fraction() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    /// In [-1, 1).
    double symmetric() { return 2 * fraction() - 1; }
    /// Uniform on the sphere.
    analytic::Point direction();

private:
    std::mt19937_64 engine_;
};

/// A random stable stiffness (Pa) of one of the symmetry_classes(), its axes along z, x: Kelvin's matrix with random axes and six moduli
/// between 5 and 200 GPa, more of them low than high, averaged over the rotations of the class (rotations of a hexagon make a tensor of
/// fourth order transversely isotropic, those of an icosahedron isotropic: Hermann 1934). A mean of positive definite matrices is one, and
/// its moduli lie between the same bounds: no tensor's condition is worse than 40. Throws std::invalid_argument for an unknown class.
analytic::Stiffness random_stiffness(const std::string& symmetry, SeededNumbers& numbers);

}  // namespace cleave::validation
