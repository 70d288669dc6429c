#include "reference_fem/constitutive.hpp"

#include "reference_fem/vector3.hpp"

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

bool is_frame(const Frame& axes) {
    for (int i = 0; i < 3; ++i) {
        const Point expected = cross(axes[i], axes[(i + 1) % 3]);
        if (!(norm(expected - axes[(i + 2) % 3]) <= 1e-9 && std::abs(norm(axes[i]) - 1) <= 1e-9)) return false;
    }
    return true;
}

using Tensor4 = std::array<std::array<Tensor, 3>, 3>;

Tensor4 tensor_of(const Stiffness& stiffness) {
    Tensor4 tensor{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) tensor[i][j][k][l] = stiffness[voigt_index(i, j)][voigt_index(k, l)];
    return tensor;
}

/// One index of four brought into the axes of the mesh, and moved to the front: C'_lijk = axes[m][l] C_ijkm. Four calls turn all four
/// and leave their order. A factor of exactly 1 or 0 changes no bit.
Tensor4 turned_by_last_index(const Tensor4& tensor, const Frame& axes) {
    Tensor4 result{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l)
                    for (int m = 0; m < 3; ++m) result[l][i][j][k] += axes[m][l] * tensor[i][j][k][m];
    return result;
}

Tensor4 turned(Tensor4 tensor, const Frame& axes) {
    for (int index = 0; index < 4; ++index) tensor = turned_by_last_index(tensor, axes);
    return tensor;
}

}  // namespace

Elasticity::Elasticity(const Region& region) {
    const Stiffness& given = region.stiffness;
    if (!is_symmetric(given)) throw Error(fmt::format("region {}: the stiffness is not a finite symmetric matrix", region.id));
    if (!is_positive_definite(given)) throw Error(fmt::format("region {}: the stiffness is not positive definite", region.id));
    if (!is_frame(region.frame)) throw Error(fmt::format("region {}: the material axes are not orthonormal and right-handed", region.id));
    tensor_ = turned(tensor_of(given), region.frame);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) stiffness_[voigt_index(i, j)][voigt_index(k, l)] = tensor_[i][j][k][l];
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
