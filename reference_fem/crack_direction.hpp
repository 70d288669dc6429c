#pragma once

#include "reference_fem/near_tip.hpp"

#include <functional>

namespace cleave::fem {

/// Angle (rad, from the crack's plane, positive towards its normal) at which hoop stress over toughness of the near-tip field is largest:
/// Erdogan and Sih (1963) for an isotropic material and uniform toughness, Saouma, Ayari and Leavell (1987) otherwise. `toughness` is K_c by
/// angle over any constant. `stiffness` in axes of the front. A grid of half a degree, then golden section; of equal maxima the first found
/// from the crack's plane outwards.
double kink_angle(const Stiffness& stiffness, const Intensities& k, const std::function<double(double angle)>& toughness);

/// The largest principal stress of an un-notched body: a crack starts across `direction` where the gap is wide enough for it to mean anything.
struct PrincipalStress {
    double value = 0;   ///< Pa
    Point direction{};  ///< unit vector, without sense: the crack's normal
    double gap = 0;     ///< (largest - second) / Frobenius norm of the tensor; 0 for no stress
};
PrincipalStress largest_principal_stress(const Voigt& stress);

/// Hoop stress of the near-tip field times sqrt(2 pi r), Pa m^0.5, at an angle from the crack's plane.
double hoop_stress(const Stiffness& stiffness, const NearTip& tip, const Intensities& k, double angle);

}  // namespace cleave::fem
