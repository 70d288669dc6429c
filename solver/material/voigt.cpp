#include "solver/material/voigt.hpp"

#include <array>

namespace cleave::material {

namespace {

/// The two indices of each Voigt row, and the Voigt row of each index pair.
constexpr std::array<std::array<int, 2>, 6> pair_of{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
constexpr std::array<std::array<int, 3>, 3> row_of{{{0, 5, 4}, {5, 1, 3}, {4, 3, 2}}};

Voigt to_voigt(const Eigen::Matrix3d& m, double shear_factor) {
    const Eigen::Matrix3d s = 0.5 * (m + m.transpose());
    Voigt v;
    v << s(0, 0), s(1, 1), s(2, 2), shear_factor * s(1, 2), shear_factor * s(0, 2), shear_factor * s(0, 1);
    return v;
}

Eigen::Matrix3d from_voigt(const Voigt& v, double shear_factor) {
    Eigen::Matrix3d m;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) m(i, j) = v(row_of[i][j]) * (i == j ? 1.0 : shear_factor);
    return m;
}

/// Bond's 6x6 matrix K: Voigt(R s R^T) = K Voigt(s) for a stress s.
Stiffness bond_matrix(const Eigen::Matrix3d& r) {
    Stiffness bond;
    for (int row = 0; row < 6; ++row) {
        const auto [i, j] = pair_of[row];
        for (int column = 0; column < 6; ++column) {
            const auto [a, b] = pair_of[column];
            // A shear column stands for both s_ab and s_ba.
            bond(row, column) = a == b ? r(i, a) * r(j, a) : r(i, a) * r(j, b) + r(i, b) * r(j, a);
        }
    }
    return bond;
}

double rotated_component(const Stiffness& c, const Eigen::Matrix3d& r, int i, int j, int k, int l) {
    double sum = 0;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            for (int d = 0; d < 3; ++d)
                for (int e = 0; e < 3; ++e) sum += r(i, a) * r(j, b) * r(k, d) * r(l, e) * c(row_of[a][b], row_of[d][e]);
    return sum;
}

}  // namespace

Voigt strain_to_voigt(const Eigen::Matrix3d& strain) { return to_voigt(strain, 2); }
Eigen::Matrix3d strain_from_voigt(const Voigt& strain) { return from_voigt(strain, 0.5); }
Voigt stress_to_voigt(const Eigen::Matrix3d& stress) { return to_voigt(stress, 1); }
Eigen::Matrix3d stress_from_voigt(const Voigt& stress) { return from_voigt(stress, 1); }

Stiffness rotate_stiffness(const Stiffness& stiffness, const Eigen::Matrix3d& rotation) {
    const Stiffness bond = bond_matrix(rotation);
    const Stiffness rotated = bond * stiffness * bond.transpose();
    return 0.5 * (rotated + rotated.transpose());
}

Stiffness rotate_stiffness_by_components(const Stiffness& stiffness, const Eigen::Matrix3d& rotation) {
    Stiffness rotated;
    for (int row = 0; row < 6; ++row)
        for (int column = 0; column < 6; ++column)
            rotated(row, column) = rotated_component(stiffness, rotation, pair_of[row][0], pair_of[row][1], pair_of[column][0],
                                                     pair_of[column][1]);
    return rotated;
}

}  // namespace cleave::material
