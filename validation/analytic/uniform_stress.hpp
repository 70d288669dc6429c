#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

/// A body of any material under a stress that is the same everywhere: u = S sigma x, without rotation about the origin. The stress (Pa,
/// Voigt) is given in axes turned by `angle` (radians) about `axis`, as a material may be.
Field uniform_stress(const Stiffness& stiffness, const Voigt& stress, const Point& axis, double angle);

}  // namespace cleave::analytic
