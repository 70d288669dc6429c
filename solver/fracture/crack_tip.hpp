#pragma once

#include "solver/fracture/toughness.hpp"
#include "solver/material/voigt.hpp"

#include <Eigen/Core>

namespace cleave::fracture {

/// Stress intensities of a crack front (Pa m^0.5), in the order of the crack's axes: sliding along its growth, opening, tearing.
struct Intensities {
    double II = 0, I = 0, III = 0;
};

enum class TipCriterion {
    hoop,            ///< largest hoop stress (Erdogan and Sih 1963)
    energy,          ///< largest energy release rate of a small kink
    weighted_hoop    ///< largest hoop stress over toughness (Saouma et al. 1987)
};

/// A crack front: axes x along the growth of the straight crack, y normal to its plane, z along the front (columns of `axes`, a rotation).
struct TipFrame {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// Where a crack grows.
struct Kink {
    double angle = 0;          ///< rad, from the crack's plane, positive towards +y
    Eigen::Vector3d normal;    ///< unit, of the new crack plane, in the body's axes
    double strength = 0;       ///< what was maximised: Pa m^0.5 (hoop), J/m^2 (energy)
};

/// Direction in which an existing crack grows in a material of any anisotropy (`stiffness` in the body's axes, Pa). Plane strain along the
/// front.
Kink kink_direction(const material::Stiffness& stiffness, const TipFrame& frame, const Intensities& intensities, TipCriterion criterion,
                    const Toughness& toughness = Toughness::uniform(1));

/// G = k^T L^-1 k / 2 (J/m^2), L the Barnett-Lothe tensor of the front: any anisotropy.
double energy_release(const material::Stiffness& stiffness, const TipFrame& frame, const Intensities& intensities);

/// E' (Pa) with G = K_I^2 / E' for a penny crack of this normal, the mean over its front: 1/E' = n L'^-1 n / 2, L' the mean of L over the
/// directions of the front. E / (1 - nu^2) where isotropic.
double effective_modulus(const material::Stiffness& stiffness, const Eigen::Vector3d& crack_normal);

}  // namespace cleave::fracture
