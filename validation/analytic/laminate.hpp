#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

/// Two half-spaces, `lower` below z = height (m) and `upper` above, each of any stiffness, under a piecewise linear displacement:
/// u = A x below; above, the gradient is A + d (x) n with n = z, u continuous at the interface, and d such that the traction is,
///   Q d = (C_lower : A - C_upper : A) n,   Q_ik = n_j C_upper,ijkl n_l (the acoustic tensor),
/// (Hadamard's compatibility; Ting 1996, Anisotropic Elasticity, ch. 3). Stress is constant in each half, no body force.
/// Points on the interface count as `lower`.
Field laminate(const Stiffness& lower, const Stiffness& upper, double height, const Gradient& gradient_below);

}  // namespace cleave::analytic
