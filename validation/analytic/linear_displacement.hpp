#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

/// u = A x: the patch test (Irons and Razzaque 1972). Any consistent method must reproduce it for any C and any mesh.
Field linear_displacement(const Stiffness& stiffness, const Gradient& gradient);

/// A gradient without any symmetry, strains of order 1e-3.
Gradient generic_gradient();

}  // namespace cleave::analytic
