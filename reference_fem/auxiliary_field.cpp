#include "reference_fem/auxiliary_field.hpp"

#include "reference_fem/vector3.hpp"

#include <cmath>

namespace cleave::fem {
namespace {

/// Cubic through four nodes along the front: one every 5 degrees of a circle errs by 1e-6 of what varies.
constexpr long nodes_per_loop = 72;

/// Lagrange's weights of the nodes -1, 0, 1, 2 at t in [0, 1).
std::array<double, 4> cubic_weights(double t) {
    return {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2, (t + 1) * t * (t - 1) / 6};
}

void add_scaled(NearTip::State& sum, double weight, const NearTip::State& state) {
    for (int mode = 0; mode < 3; ++mode) {
        sum.displacement[mode] = sum.displacement[mode] + weight * state.displacement[mode];
        for (int d = 0; d < 2; ++d) sum.slope[mode][d] = sum.slope[mode][d] + weight * state.slope[mode][d];
    }
}

Point moved(Point x, int axis, double by) {
    x[axis] += by;
    return x;
}

/// Distance from the lips, which part the field: differences must not reach across.
double to_lips(const FrontPlace& place) { return place.ahead < 0 ? std::abs(place.above) : std::hypot(place.ahead, place.above); }

bool varies_along(const Elasticity& material, const CrackFront& front) {
    if (front.loop == 0) return false;
    const Stiffness one = in_axes(material, front.locate(front.point_at(0)).axes);
    for (const double share : {0.11, 0.23, 0.37}) {
        const Stiffness other = in_axes(material, front.locate(front.point_at(share * front.loop)).axes);
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                if (std::abs(one[i][j] - other[i][j]) > 1e-9 * one[0][0]) return true;
    }
    return false;
}

}  // namespace

AuxiliaryField::AuxiliaryField(const Elasticity& material, const CrackFront& front, TipForm form)
    : material_(material), front_(front), form_(form) {
    if (!varies_along(material, front)) uniform_ = near_tip(in_axes(material, front.locate(front.point_at(0)).axes), form);
}

const NearTip& AuxiliaryField::node_tip(long node) const {
    node = (node % nodes_per_loop + nodes_per_loop) % nodes_per_loop;
    auto& tip = tips_[node];
    if (!tip) tip = near_tip(in_axes(material_, front_.locate(front_.point_at(front_.loop * static_cast<double>(node) / nodes_per_loop)).axes), form_);
    return *tip;
}

NearTip::State AuxiliaryField::plane_state(const FrontPlace& place) const {
    if (uniform_) return uniform_->at(place.ahead, place.above);
    const double position = place.along / front_.loop * nodes_per_loop;
    const long before = static_cast<long>(std::floor(position));
    const std::array<double, 4> weights = cubic_weights(position - static_cast<double>(before));
    NearTip::State state;
    for (int k = 0; k < 4; ++k) add_scaled(state, weights[k], node_tip(before - 1 + k).at(place.ahead, place.above));
    return state;
}

std::array<Point, 3> AuxiliaryField::displacement(const Point& x) const {
    const FrontPlace place = front_.locate(x);
    const NearTip::State state = plane_state(place);
    std::array<Point, 3> v{};
    for (int mode = 0; mode < 3; ++mode)
        for (int i = 0; i < 3; ++i) v[mode] = v[mode] + state.displacement[mode][i] * place.axes[i];
    return v;
}

/// Straight fronts: from the plane fields. Curved ones: central differences of v, 1e-4 of the distance from the front (error 1e-8).
std::array<Tensor, 3> AuxiliaryField::gradient(const Point& x) const {
    const FrontPlace place = front_.locate(x);
    std::array<Tensor, 3> gradient{};
    if (front_.loop == 0) {
        const NearTip::State state = plane_state(place);
        for (int mode = 0; mode < 3; ++mode)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    for (int p = 0; p < 3; ++p)
                        for (int d = 0; d < 2; ++d) gradient[mode][i][j] += place.axes[p][i] * state.slope[mode][d][p] * place.axes[d][j];
        return gradient;
    }
    const double step = std::min(1e-4 * std::hypot(place.ahead, place.above), to_lips(place) / 2);
    for (int j = 0; j < 3; ++j) {
        const auto plus = displacement(moved(x, j, step)), minus = displacement(moved(x, j, -step));
        for (int mode = 0; mode < 3; ++mode)
            for (int i = 0; i < 3; ++i) gradient[mode][i][j] = (plus[mode][i] - minus[mode][i]) / (2 * step);
    }
    return gradient;
}

std::array<Voigt, 3> AuxiliaryField::stresses(const std::array<Tensor, 3>& gradient) const {
    return {material_.stress(gradient[0]), material_.stress(gradient[1]), material_.stress(gradient[2])};
}

AuxiliaryField::State AuxiliaryField::at(const Point& x, bool with_divergence) const {
    State state;
    state.gradient = gradient(x);
    state.stress = stresses(state.gradient);
    if (!with_divergence || front_.loop == 0) return state;
    const FrontPlace place = front_.locate(x);
    const double step = std::min(5e-3 * std::hypot(place.ahead, place.above), to_lips(place) / 2);
    for (int j = 0; j < 3; ++j) {
        const auto plus = stresses(gradient(moved(x, j, step))), minus = stresses(gradient(moved(x, j, -step)));
        for (int mode = 0; mode < 3; ++mode)
            for (int i = 0; i < 3; ++i)
                state.divergence[mode][i] += (plus[mode][voigt_index(i, j)] - minus[mode][voigt_index(i, j)]) / (2 * step);
    }
    return state;
}

}  // namespace cleave::fem
