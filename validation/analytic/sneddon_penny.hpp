#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

/// Penny crack of radius a (m) in an infinite isotropic solid, opened by a pressure p (Pa) on its lips or by a remote tension p
/// normal to it (Sneddon 1946, Proc. R. Soc. A 187, 229). Scalars only:
///   energy_release_rate  G = 4 (1 - nu^2) p^2 a / (pi E)              J/m^2
///   crack_opening        2 u_z(0) = 8 (1 - nu^2) p a / (pi E)         m, at the centre
///   energy               8 (1 - nu^2) p^2 a^3 / (3 E)                 J, work of the pressure / 2
/// `box_factor` multiplies all three: a finite, clamped box is a little stiffer than infinite space.
/// Throws std::invalid_argument where the stiffness is not isotropic to 1e-6.
Field sneddon_penny(const Stiffness& stiffness, double radius, double pressure, double box_factor);

}  // namespace cleave::analytic
