#pragma once

#include "reference_fem/problem.hpp"

#include <cstdint>

/// Materials and tensor algebra of the tests, written apart from the code under test.
namespace cleave::fem::testing {

/// The tensor pair of each Voigt position: yz, xz, xy after the normal components. Spelt out, not computed.
constexpr std::array<std::array<int, 2>, 6> voigt_pairs{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
constexpr std::array<std::array<int, 3>, 3> voigt_of{{{0, 5, 4}, {5, 1, 3}, {4, 3, 2}}};

using Tensor2 = std::array<std::array<double, 3>, 3>;

/// 21 independent constants: 30 GPa * (2 I + A A^T / 3), A from a fixed linear congruential sequence in (-1, 1). Positive definite by form.
inline Stiffness triclinic(std::uint32_t seed = 1) {
    Stiffness a{}, stiffness{};
    for (auto& row : a)
        for (double& entry : row) {
            seed = seed * 1664525u + 1013904223u;
            entry = seed / 2147483648.0 - 1;
        }
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            double product = 0;
            for (int k = 0; k < 6; ++k) product += a[i][k] * a[j][k];
            stiffness[i][j] = 30e9 * (product / 3 + (i == j ? 2 : 0));
        }
    return stiffness;
}

/// sigma = C eps, with shear strain doubled here, from a displacement gradient; as a full tensor.
inline Tensor2 stress_tensor(const Stiffness& stiffness, const Tensor2& gradient) {
    Tensor2 stress{};
    for (int p = 0; p < 6; ++p) {
        double sum = 0;
        for (int q = 0; q < 6; ++q) {
            const auto [k, l] = voigt_pairs[q];
            sum += stiffness[p][q] * (k == l ? gradient[k][k] : gradient[k][l] + gradient[l][k]);
        }
        const auto [i, j] = voigt_pairs[p];
        stress[i][j] = stress[j][i] = sum;
    }
    return stress;
}

/// C'_ijkl = R_ia R_jb R_kc R_ld C_abcd.
inline Stiffness rotated(const Stiffness& stiffness, const Tensor2& rotation) {
    Stiffness result{};
    for (int p = 0; p < 6; ++p)
        for (int q = 0; q < 6; ++q)
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b)
                    for (int c = 0; c < 3; ++c)
                        for (int d = 0; d < 3; ++d)
                            result[p][q] += rotation[voigt_pairs[p][0]][a] * rotation[voigt_pairs[p][1]][b] *
                                            rotation[voigt_pairs[q][0]][c] * rotation[voigt_pairs[q][1]][d] *
                                            stiffness[voigt_of[a][b]][voigt_of[c][d]];
    return result;
}

inline Point times(const Tensor2& matrix, const Point& v) {
    Point result{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result[i] += matrix[i][j] * v[j];
    return result;
}

}  // namespace cleave::fem::testing
