#pragma once

#include "reference_fem/near_tip.hpp"

#include <array>

namespace cleave::fem {

/// Stress intensities of a kink, small against the crack, at the angle `angle` (rad, |angle| <= 120 degrees, towards the crack's normal) in an
/// isotropic body: K'_I = F[0][0] K_I + F[0][1] K_II, K'_II = F[1][0] K_I + F[1][1] K_II; the elastic constants do not matter. By the singular
/// integral equation of the dislocations that make the kink beside a half-infinite crack (Lo 1978, J. Appl. Mech. 45, 797), solved numerically
/// to 1e-5: nothing is expanded in the angle.
using KinkFactors = std::array<std::array<double, 2>, 2>;
KinkFactors kink_factors(double angle);

/// Angle (rad, from the crack's plane, positive towards its normal) of the small kink of largest energy release rate among those that open,
/// (K'_I^2 + K'_II^2) (1 - nu^2) / E, within 85 degrees; K_III does not count. `stiffness` in axes of the front; throws Error unless isotropic.
double energy_kink_angle(const Stiffness& stiffness, const Intensities& k);

}  // namespace cleave::fem
