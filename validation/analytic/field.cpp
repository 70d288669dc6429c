#include "validation/analytic/field.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace cleave::analytic {

namespace {
constexpr int voigt_index[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
constexpr int first_index[6] = {0, 1, 2, 1, 0, 0};
constexpr int second_index[6] = {0, 1, 2, 2, 2, 1};
}  // namespace

Voigt strain_of(const Gradient& g) {
    return {g[0][0], g[1][1], g[2][2], g[1][2] + g[2][1], g[0][2] + g[2][0], g[0][1] + g[1][0]};
}

double component(const Stiffness& stiffness, int i, int j, int k, int l) {
    return stiffness[static_cast<std::size_t>(voigt_index[i][j])][static_cast<std::size_t>(voigt_index[k][l])];
}

Voigt stress_of(const Stiffness& stiffness, const Gradient& gradient) {
    Voigt stress{};
    for (std::size_t I = 0; I < 6; ++I)
        for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l)
                stress[I] += component(stiffness, first_index[I], second_index[I], k, l) *
                             gradient[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)];
    return stress;
}

Stiffness invert(const Stiffness& stiffness) {
    // Gauss-Jordan with partial pivoting, rows scaled by the largest entry so that pivots compare with 1.
    double scale = 0;
    for (const auto& row : stiffness)
        for (const double value : row) scale = std::max(scale, std::abs(value));
    Stiffness left = stiffness, inverse{};
    for (std::size_t i = 0; i < 6; ++i) {
        for (double& value : left[i]) value /= scale;
        inverse[i][i] = 1 / scale;
    }
    for (std::size_t column = 0; column < 6; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column + 1; row < 6; ++row)
            if (std::abs(left[row][column]) > std::abs(left[pivot][column])) pivot = row;
        if (!(std::abs(left[pivot][column]) > 1e-14)) throw std::invalid_argument("a stiffness that can be inverted");
        std::swap(left[pivot], left[column]);
        std::swap(inverse[pivot], inverse[column]);
        const double factor = 1 / left[column][column];
        for (std::size_t k = 0; k < 6; ++k) {
            left[column][k] *= factor;
            inverse[column][k] *= factor;
        }
        for (std::size_t row = 0; row < 6; ++row) {
            if (row == column) continue;
            const double multiple = left[row][column];
            for (std::size_t k = 0; k < 6; ++k) {
                left[row][k] -= multiple * left[column][k];
                inverse[row][k] -= multiple * inverse[column][k];
            }
        }
    }
    return inverse;
}

}  // namespace cleave::analytic
