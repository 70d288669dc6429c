#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

/// Young's modulus (Pa) of a bar cut along a unit vector n, 1 / (n n : S : n n), without the compliance S: in axes with the third along n the
/// stress has one component, and the other five equations sigma = 0 are eliminated one after the other; what is left of C33 is the modulus
/// (static condensation, the Schur complement; Guyan 1965). Throws std::invalid_argument where the stiffness is not positive definite.
double bar_modulus(const Stiffness& stiffness, const Point& direction);

}  // namespace cleave::analytic
