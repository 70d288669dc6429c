#include "reference_fem/crack_direction.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace cleave::fem {

PrincipalStress largest_principal_stress(const Voigt& stress) {
    Eigen::Matrix3d tensor;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) tensor(i, j) = stress[voigt_index(i, j)];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(tensor);
    const Eigen::Vector3d values = eigen.eigenvalues(), n = eigen.eigenvectors().col(2);
    const double size = tensor.norm();
    return {values[2], {n[0], n[1], n[2]}, size > 0 ? (values[2] - values[1]) / size : 0};
}

double hoop_stress(const Stiffness& stiffness, const NearTip& tip, const Intensities& k, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const NearTip::State state = tip.at(c, s);
    Tensor gradient{};
    for (int mode = 0; mode < 3; ++mode)
        for (int i = 0; i < 3; ++i)
            for (int d = 0; d < 2; ++d) gradient[i][d] += k[mode] * state.slope[mode][d][i];
    const Voigt strain = engineering_strain(gradient);
    Voigt stress{};
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) stress[i] += stiffness[i][j] * strain[j];
    // On the plane with normal (-s, c) at r = 1.
    return std::sqrt(2 * std::numbers::pi) * (s * s * stress[0] + c * c * stress[1] - 2 * s * c * stress[5]);
}

double kink_angle(const Stiffness& stiffness, const Intensities& k, const std::function<double(double angle)>& toughness) {
    const std::shared_ptr<const NearTip> tip = near_tip(stiffness);
    const auto driving = [&](double angle) { return hoop_stress(stiffness, *tip, k, angle) / toughness(angle); };
    constexpr double step = std::numbers::pi / 360;
    double best = 0;
    for (int n = 1; n < 359; ++n)
        for (const double angle : {n * step, -n * step})
            if (driving(angle) > driving(best) * (1 + 1e-12)) best = angle;
    double low = best - step, high = best + step;
    const double golden = (std::sqrt(5.0) - 1) / 2;
    while (high - low > 1e-9) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        if (driving(left) > driving(right))
            high = right;
        else
            low = left;
    }
    return (low + high) / 2;
}

}  // namespace cleave::fem
