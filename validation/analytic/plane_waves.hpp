#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

/// Elementary symmetric functions of three numbers: their sum, the sum of the products of two, the product of all.
using SymmetricFunctions = std::array<double, 3>;

SymmetricFunctions symmetric_functions(const std::array<double, 3>& numbers);

/// Those of the eigenvalues of Christoffel's tensor Gamma_ik = C_ijkl n_j n_l (Pa) along a unit vector n, from its entries: trace, sum of
/// the principal minors, determinant. det(Gamma - x I) = -x^3 + e1 x^2 - e2 x + e3 vanishes at x = density speed^2 of each of the three
/// plane waves along n (Auld 1973, Sect. 7). Three speeds are right where their x have these functions: no eigenvalue has to be sought.
SymmetricFunctions christoffel_functions(const Stiffness& stiffness, const Point& direction);

/// Largest relative difference of the functions of density speed^2 (kg/m^3, m/s) from those of Christoffel's tensor.
double wave_speed_error(const Stiffness& stiffness, double density, const Point& direction, const std::array<double, 3>& speeds);

}  // namespace cleave::analytic
