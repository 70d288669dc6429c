#pragma once

#include "validation/analytic/lekhnitskii_crack.hpp"

#include <array>

namespace cleave::analytic {

/// Angle (rad) at which a crack in an isotropic solid grows where the hoop stress is largest (Erdogan and Sih 1963, J. Basic Eng. 85, 519):
/// K_I sin theta + K_II (3 cos theta - 1) = 0, the root of tension.
double hoop_kink_angle(double K_I, double K_II);

/// Stress intensities of a small kink at the angle theta: K'_I = F11 K_I + F12 K_II, K'_II = F21 K_I + F22 K_II; {F11, F12, F21, F22} by
/// the expansions of Amestoy and Leblond (1992, Int. J. Solids Structures 29, 465), |theta| <= 80 deg to 1e-3.
std::array<double, 4> kink_factors(double angle);

/// Angle (rad) of the kink of largest energy release rate, (K'_I^2 + K'_II^2) / E'.
double energy_kink_angle(double K_I, double K_II);

/// Angle (rad) of the kink without shear, K'_II = 0 (local symmetry).
double symmetry_kink_angle(double K_I, double K_II);

/// Toughness of a material with a weak plane, K_c(theta) / K_0 = cos^2 + ratio sin^2 of the angle from that plane (Saouma, Ayari and
/// Leavell 1987, Eng. Fract. Mech. 27, 171); `weak_plane` is the plane's angle from the crack, rad.
struct WeakPlane {
    double ratio = 1;  ///< K_90 / K_0
    double weak_plane = 0;
};

/// Angle (rad, |angle| <= 180 deg) at which the anisotropic hoop stress over the toughness is largest (Saouma et al. 1987). With the
/// ratio 1 the bare hoop stress. Of two equal maxima either.
double anisotropic_kink_angle(const AnisotropicHoop& hoop, double K_I, double K_II, const WeakPlane& toughness);

}  // namespace cleave::analytic
