#pragma once

#include "reference_fem/crack_front.hpp"
#include "reference_fem/near_tip.hpp"

#include <map>
#include <memory>

namespace cleave::fem {

/// The three near-tip fields (units of K_II, K_I, K_III) carried along a front: v(x) = the front's axes at x times the plane field at
/// (ahead, above), one compatible displacement field in space. On a straight front it is in balance and leaves the lips free; on a curved
/// one its stress (that of the true gradient of v) has a divergence of order K r^-1/2 / R and tractions of order K r^1/2 / R on the lips,
/// R the radius of the front: the interaction integral takes both into account.
/// Not for several threads at once.
class AuxiliaryField {
public:
    /// `material` must outlive the field.
    AuxiliaryField(const Elasticity& material, const CrackFront& front, TipForm form = TipForm::automatic);

    struct State {
        std::array<Tensor, 3> gradient{};    ///< by mode; gradient[i][j] = dv_i/dx_j
        std::array<Voigt, 3> stress{};       ///< Pa
        std::array<Point, 3> divergence{};   ///< of the stress, N/m^3; only where asked for
    };
    State at(const Point& x, bool with_divergence) const;
    std::array<Point, 3> displacement(const Point& x) const;  ///< by mode, m

    const CrackFront& front() const { return front_; }
    /// Near-tip fields at the place of the front nearest to x.
    std::shared_ptr<const NearTip> tip(const Point& x) const { return near_tip(in_axes(material_, front_.locate(x).axes), form_); }

private:
    std::array<Tensor, 3> gradient(const Point& x) const;
    std::array<Voigt, 3> stresses(const std::array<Tensor, 3>& gradient) const;
    const NearTip& node_tip(long node) const;
    NearTip::State plane_state(const FrontPlace& place) const;

    const Elasticity& material_;
    CrackFront front_;
    TipForm form_;
    std::shared_ptr<const NearTip> uniform_;                       // where all places of the front have the same
    mutable std::map<long, std::shared_ptr<const NearTip>> tips_;  // else at nodes along the front
};

}  // namespace cleave::fem
