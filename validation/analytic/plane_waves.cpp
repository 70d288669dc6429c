#include "validation/analytic/plane_waves.hpp"

#include "validation/analytic/barnett_lothe.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::analytic {

SymmetricFunctions symmetric_functions(const std::array<double, 3>& numbers) {
    const auto& [a, b, c] = numbers;
    return {a + b + c, a * b + b * c + c * a, a * b * c};
}

SymmetricFunctions christoffel_functions(const Stiffness& stiffness, const Point& direction) {
    const Matrix gamma = contracted(stiffness, direction, direction);
    const auto minor = [&](std::size_t a, std::size_t b) { return gamma[a][a] * gamma[b][b] - gamma[a][b] * gamma[b][a]; };
    const double determinant = gamma[0][0] * minor(1, 2) - gamma[0][1] * (gamma[1][0] * gamma[2][2] - gamma[1][2] * gamma[2][0]) +
                               gamma[0][2] * (gamma[1][0] * gamma[2][1] - gamma[1][1] * gamma[2][0]);
    return {gamma[0][0] + gamma[1][1] + gamma[2][2], minor(0, 1) + minor(1, 2) + minor(0, 2), determinant};
}

double wave_speed_error(const Stiffness& stiffness, double density, const Point& direction, const std::array<double, 3>& speeds) {
    const auto& [slow, fast, longitudinal] = speeds;
    const SymmetricFunctions found = symmetric_functions({density * slow * slow, density * fast * fast, density * longitudinal * longitudinal});
    const SymmetricFunctions exact = christoffel_functions(stiffness, direction);
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double error = std::abs(found[i] / exact[i] - 1);
        if (!(error <= worst)) worst = error;  // a NaN stays
    }
    return worst;
}

}  // namespace cleave::analytic
