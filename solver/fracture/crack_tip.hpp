#pragma once

#include "solver/fracture/toughness.hpp"
#include "solver/material/voigt.hpp"

#include <Eigen/Core>

namespace cleave::fracture {

/// Stress intensities of a crack front, Pa m^0.5.
struct Intensities {
    double I = 0;    ///< opening
    double II = 0;   ///< sliding along the growth
    double III = 0;  ///< tearing along the front
};

/// What decides where an existing crack grows.
enum class TipCriterion {
    hoop,          ///< largest hoop stress (Erdogan and Sih 1963)
    energy,        ///< largest energy release rate of a small kink
    weighted_hoop  ///< largest hoop stress over toughness (Saouma et al. 1987)
};

/// Axes of a crack front, columns of a rotation: x along the growth of the straight crack, y normal to it, z along the front.
using TipAxes = Eigen::Matrix3d;

struct Kink {
    double angle = 0;        ///< rad, from x towards y
    Eigen::Vector3d normal;  ///< unit, of the new crack plane, in the axes of the body
    double driving = 0;      ///< what was maximised: Pa m^0.5 (hoop), J/m^2 (energy)
};

/// Direction in which a crack grows in a material of any anisotropy (`stiffness` in the axes of the body, Pa), plane strain along the
/// front. The tractions ahead of the tip are Stroh's: t sqrt(2 pi r) = Re[B diag(sqrt(cos q + p sin q)) B^-1] k on the ray at angle q.
///
/// `energy` is that of a kink far shorter than the crack. Isotropic materials: K* = F K with the expansion of Amestoy and Leblond (1992),
/// tearing after Sih (1965). Anisotropic: k* is taken from the tractions on the ray before it opens, which is right to first order in the
/// angle and makes the isotropic pure-sliding kink 70.5 instead of 75.8 degrees. Kinks that would close do not count.
Kink kink_direction(const material::Stiffness& stiffness, const TipAxes& axes, const Intensities& intensities, TipCriterion criterion,
                    const Toughness& toughness = Toughness::uniform(1));

/// G = k^T L^-1 k / 2 (J/m^2) of the straight crack, L the Barnett-Lothe tensor of the front: any anisotropy.
double energy_release(const material::Stiffness& stiffness, const TipAxes& axes, const Intensities& intensities);

/// E' (Pa) with G = K_I^2 / E' for a penny crack of this normal, means along its front: 1/E' = n L'^-1 n / 2, L' the mean of L over the
/// directions of the front. E / (1 - nu^2) where isotropic.
double effective_modulus(const material::Stiffness& stiffness, const Eigen::Vector3d& crack_normal);

}  // namespace cleave::fracture
