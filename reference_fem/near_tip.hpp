#pragma once

#include "reference_fem/constitutive.hpp"

#include <array>
#include <memory>

namespace cleave::fem {

/// Stress intensities K_II, K_I, K_III, Pa m^0.5: sliding ahead, opening, tearing along the front.
using Intensities = std::array<double, 3>;

/// Leading fields of a straight front in generalised plane strain, in axes of the front: 1 ahead, 2 normal to the crack, 3 along the front.
/// Entry j of an array over modes belongs to a unit of K_II, K_I, K_III.
class NearTip {
public:
    virtual ~NearTip() = default;

    struct State {
        std::array<Point, 3> displacement{};                ///< by mode, m
        std::array<std::array<Point, 2>, 3> slope{};        ///< by mode: du/dx1 and du/dx2
    };
    /// At ahead = x1, above = x2 (m), not at the tip; above = +-0 of its sign on the lips.
    virtual State at(double x1, double x2) const = 0;

    /// L^-1 (1/Pa): G = k L^-1 k / 2 with k = (K_II, K_I, K_III) (Barnett and Asaro 1972).
    virtual Tensor compliance() const = 0;
};

enum class TipForm {
    automatic,  ///< isotropic for an isotropic stiffness, Stroh otherwise
    isotropic,  ///< closed form (Williams 1957, J. Appl. Mech. 24, 109)
    stroh       ///< eigenvectors of the fundamental elasticity matrix (Stroh 1958; Ting 1996, Anisotropic Elasticity, section 11.2)
};

/// `stiffness` in axes of the front. Throws Error where `isotropic` is asked for and the stiffness is not isotropic to 1e-6.
/// Stroh's form of a degenerate stiffness (equal roots, isotropy among them) is that of one changed by 1e-7.
std::shared_ptr<const NearTip> near_tip(const Stiffness& stiffness, TipForm form = TipForm::automatic);

/// The stiffness as seen in the axes: C'_ijkl = a_ip a_jq a_kr a_ls C_pqrs.
Stiffness in_axes(const Elasticity& material, const std::array<Point, 3>& axes);

/// G = k L^-1 k / 2, J/m^2.
double energy_release(const NearTip& tip, const Intensities& k);

}  // namespace cleave::fem
