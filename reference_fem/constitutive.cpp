#include "reference_fem/constitutive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cleave::fem {
namespace {

bool is_symmetric(const Stiffness& stiffness) {
    double largest = 0, difference = 0;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            if (!std::isfinite(stiffness[i][j])) return false;
            largest = std::max(largest, std::abs(stiffness[i][j]));
            difference = std::max(difference, std::abs(stiffness[i][j] - stiffness[j][i]));
        }
    return difference <= 1e-9 * largest;
}

/// Whether all pivots of the Cholesky factorisation are positive. A pivot below 1e-13 of its diagonal entry is rounding.
bool is_positive_definite(const Stiffness& stiffness) {
    Stiffness factor{};
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j <= i; ++j) {
            double rest = stiffness[i][j];
            for (int k = 0; k < j; ++k) rest -= factor[i][k] * factor[j][k];
            if (i == j && !(rest > 1e-13 * stiffness[i][i])) return false;
            factor[i][j] = i == j ? std::sqrt(rest) : rest / factor[j][j];
        }
    return true;
}

}  // namespace

Elasticity::Elasticity(const Stiffness& stiffness, int region) : stiffness_(stiffness) {
    if (!is_symmetric(stiffness)) throw Error(fmt::format("region {}: the stiffness is not a finite symmetric matrix", region));
    if (!is_positive_definite(stiffness)) throw Error(fmt::format("region {}: the stiffness is not positive definite", region));
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) tensor_[i][j][k][l] = stiffness[voigt_index(i, j)][voigt_index(k, l)];
}

Voigt Elasticity::stress(const Tensor& gradient) const { return stress(engineering_strain(gradient)); }

Voigt Elasticity::stress(const Voigt& strain) const {
    Voigt stress{};
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) stress[i] += stiffness_[i][j] * strain[j];
    return stress;
}

Voigt engineering_strain(const Tensor& gradient) {
    Voigt strain{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) strain[voigt_index(i, j)] += gradient[i][j];
    return strain;
}

}  // namespace cleave::fem
