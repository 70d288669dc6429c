#include "solver/fracture/crack_tip.hpp"

#include "solver/contact/contact_load.hpp"
#include "solver/contact/half_space.hpp"
#include "solver/contact/stroh_table.hpp"

#include <Eigen/LU>

#include <cmath>
#include <functional>
#include <numbers>

namespace cleave::fracture {

namespace {

using std::numbers::pi;

/// Axes of Stroh's problem: x along the growth, z normal to the crack, so y against the front.
Eigen::Matrix3d stroh_axes(const TipAxes& axes) {
    Eigen::Matrix3d result;
    result << axes.col(0), -axes.col(2), axes.col(1);
    return result;
}

material::Stiffness in_axes(const material::Stiffness& stiffness, const Eigen::Matrix3d& axes) {
    return material::rotate_stiffness(stiffness, axes.transpose());
}

Eigen::Vector3d in_stroh_axes(const Intensities& k) { return {k.II, -k.III, k.I}; }

/// (uv)_ik = C_ijks u_j v_s for v = z, u = x or z.
Eigen::Matrix3d contraction(const material::Stiffness& c, const std::array<int, 3>& u) {
    static constexpr std::array<int, 3> z{4, 3, 2};  // Voigt places of xz, yz, zz
    Eigen::Matrix3d result;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) result(i, k) = c(u[i], z[k]);
    return result;
}

/// The near field of a crack front in Stroh's axes.
class NearField {
public:
    NearField(const material::Stiffness& stiffness, const TipAxes& axes)
        : stiffness_(contact::StrohTable(in_axes(stiffness, stroh_axes(axes)), 1).stiffness()),
          stroh_(contact::stroh_direction(stiffness_, 0)) {
        // b = (R^T + p T) a, Ting (1996), Eq. 5.3-9: from A f B^-1 to B f B^-1.
        const Eigen::Matrix3d R = contraction(stiffness_, {0, 5, 4}), T = contraction(stiffness_, {4, 3, 2});
        for (int a = 0; a < 3; ++a) stress_matrix_[a] = (R.transpose() + stroh_.root[a] * T) * stroh_.matrix[a];
    }

    /// Traction times sqrt(2 pi r) on the ray at an angle, Pa m^0.5.
    Eigen::Vector3d traction(const Eigen::Vector3d& k, double angle) const {
        Eigen::Vector3cd sum = Eigen::Vector3cd::Zero();
        for (int a = 0; a < 3; ++a) sum += std::sqrt(std::cos(angle) + stroh_.root[a] * std::sin(angle)) * (stress_matrix_[a] * k);
        return sum.real();
    }

    /// G = k^T L^-1 k / 2, of any crack with this front: L depends on the front's direction only.
    double release_rate(const Eigen::Vector3d& k) const { return 0.5 * k.dot(inverse_barnett_lothe(stroh_) * k); }

    /// L^-1 = Re(i A B^-1), 1/Pa.
    static Eigen::Matrix3d inverse_barnett_lothe(const contact::StrohDirection& stroh) {
        return -(stroh.matrix[0] + stroh.matrix[1] + stroh.matrix[2]).imag();
    }

private:
    material::Stiffness stiffness_;
    contact::StrohDirection stroh_;
    std::array<Eigen::Matrix3cd, 3> stress_matrix_;
};

double polynomial(double x, std::initializer_list<double> descending) {
    double value = 0;
    for (const double c : descending) value = value * x + c;
    return value;
}

/// Intensities of a short kink at angle m pi in an isotropic solid (Amestoy and Leblond 1992, Int. J. Solids Struct. 29, 465, to order 20).
Intensities isotropic_kink(const Intensities& k, double angle) {
    const double m = angle / pi, x = m * m, p2 = pi * pi, p4 = p2 * p2, p6 = p4 * p2;
    const double F11 = polynomial(x, {4.1, 1.63, -4.059, 2.996, -0.0925, -2.88312, 5.07790, p2 / 9 - 11 * p4 / 72 + 119 * p6 / 15360,
                                      p2 - 5 * p4 / 128, -3 * p2 / 8, 1});
    const double F12 = m * polynomial(x, {4.56, 4.21, -6.915, 4.0216, 1.5793, -7.32433, 12.313906,
                                          -2 * pi - 133 * p2 * pi / 180 + 59 * p4 * pi / 1280, 10 * pi / 3 + p2 * pi / 16, -1.5 * pi});
    const double F21 = m * polynomial(x, {-1.32, -3.95, 4.684, -2.0700, -1.5340, 4.44112, -6.176023,
                                          -2 * pi / 3 + 13 * p2 * pi / 30 - 59 * p4 * pi / 3840, -4 * pi / 3 - p2 * pi / 48, pi / 2});
    const double F22 = polynomial(x, {12.5, 0.25, -7.591, 7.280, -1.8804, -4.78511, 10.58254,
                                      -32.0 / 15 - 4 * p2 / 9 - 1159 * p4 / 7200 + 119 * p6 / 15360, 8.0 / 3 + 29 * p2 / 18 - 5 * p4 / 128,
                                      -4 - 3 * p2 / 8, 1});
    return {F11 * k.I + F12 * k.II, F21 * k.I + F22 * k.II, std::pow((1 - m) / (1 + m), m / 2) * k.III};
}

/// The angle in [-limit, limit] where `driving` is largest: scanned, then by golden section to 1e-9 rad.
double best_angle(const std::function<double(double)>& driving, double limit) {
    constexpr int steps = 360;
    const double step = 2 * limit / steps;
    double best = -limit;
    for (int k = 1; k <= steps; ++k)
        if (const double angle = -limit + k * step; driving(angle) > driving(best)) best = angle;
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double low = std::max(best - step, -limit), high = std::min(best + step, limit);
    while (high - low > 1e-9) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        if (driving(a) < driving(b))
            low = a;
        else
            high = b;
    }
    return 0.5 * (low + high);
}

/// Hoop stress times sqrt(2 pi r): the traction's part along the normal of the ray, (-sin, 0, cos) in Stroh's axes.
double hoop(const Eigen::Vector3d& traction, double angle) { return -std::sin(angle) * traction[0] + std::cos(angle) * traction[2]; }

/// The traction that a kink's intensities mean, in Stroh's axes of the straight crack.
Eigen::Vector3d traction_of(const Intensities& kink, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * kink.II - s * kink.I, -kink.III, s * kink.II + c * kink.I};
}

}  // namespace

Kink kink_direction(const material::Stiffness& stiffness, const TipAxes& axes, const Intensities& intensities, TipCriterion criterion,
                    const Toughness& toughness) {
    const NearField field(stiffness, axes);
    const Eigen::Vector3d k = in_stroh_axes(intensities);
    const auto normal = [&](double angle) -> Eigen::Vector3d { return -std::sin(angle) * axes.col(0) + std::cos(angle) * axes.col(1); };
    const bool isotropic = contact::is_isotropic(stiffness);
    const auto driving = [&](double angle) {
        const Eigen::Vector3d traction = field.traction(k, angle);
        if (criterion == TipCriterion::hoop) return hoop(traction, angle);
        if (criterion == TipCriterion::weighted_hoop) return hoop(traction, angle) / toughness.intensity_ratio(normal(angle));
        const Eigen::Vector3d kink = isotropic ? traction_of(isotropic_kink(intensities, angle), angle) : traction;
        return hoop(kink, angle) > 0 ? field.release_rate(kink) : 0;
    };
    // The expansion is good to about 120 degrees; stresses of closed lips meet at 180.
    const double angle = best_angle(driving, criterion == TipCriterion::energy ? 2 * pi / 3 : 0.999 * pi);
    return {angle, normal(angle), driving(angle)};
}

double energy_release(const material::Stiffness& stiffness, const TipAxes& axes, const Intensities& intensities) {
    return NearField(stiffness, axes).release_rate(in_stroh_axes(intensities));
}

double effective_modulus(const material::Stiffness& stiffness, const Eigen::Vector3d& crack_normal) {
    constexpr int directions = 32;  // of a full turn; the mean over a turn converges exponentially
    const contact::StrohTable table(in_axes(stiffness, contact::surface_axes(crack_normal)), directions);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const contact::StrohDirection& direction : table.level(0)) sum += NearField::inverse_barnett_lothe(direction).inverse();
    const Eigen::Matrix3d mean = sum / static_cast<double>(table.level(0).size());
    return 2 / mean.inverse()(2, 2);
}

}  // namespace cleave::fracture
