#include "validation/studies/random_stiffness.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace cleave::validation {

namespace {

using analytic::CrackAxes;
using analytic::Stiffness;
using Rotation = CrackAxes;  // rows
using Matrix6 = std::array<std::array<double, 6>, 6>;

constexpr double least_modulus = 5e9, largest_modulus = 200e9;  // Pa

/// Rows: six orthonormal vectors in random directions (Gram and Schmidt; a row too near to the others is drawn again).
Matrix6 random_axes(SeededNumbers& numbers) {
    Matrix6 rows{};
    for (std::size_t i = 0; i < 6;) {
        for (double& value : rows[i]) value = numbers.symmetric();
        for (int twice = 0; twice < 2; ++twice)
            for (std::size_t j = 0; j < i; ++j) {
                double along = 0;
                for (std::size_t k = 0; k < 6; ++k) along += rows[i][k] * rows[j][k];
                for (std::size_t k = 0; k < 6; ++k) rows[i][k] -= along * rows[j][k];
            }
        double square = 0;
        for (const double value : rows[i]) square += value * value;
        if (square < 0.01) continue;
        for (double& value : rows[i]) value /= std::sqrt(square);
        ++i;
    }
    return rows;
}

/// Kelvin's matrix has a factor sqrt 2 for each index of shear.
Stiffness random_triclinic(SeededNumbers& numbers) {
    const Matrix6 axes = random_axes(numbers);
    Stiffness stiffness{};
    for (std::size_t k = 0; k < 6; ++k) {
        const double u = numbers.fraction(), modulus = least_modulus + (largest_modulus - least_modulus) * u * u;
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j)
                stiffness[i][j] += modulus * axes[k][i] * axes[k][j] / ((i < 3 ? 1 : std::sqrt(2.0)) * (j < 3 ? 1 : std::sqrt(2.0)));
    }
    return stiffness;
}

Rotation product(const Rotation& a, const Rotation& b) {
    Rotation result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
    return result;
}

bool equal(const Rotation& a, const Rotation& b) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            if (std::abs(a[i][j] - b[i][j]) > 1e-9) return false;
    return true;
}

/// Every product of the generators.
std::vector<Rotation> group_of(const std::vector<Rotation>& generators) {
    std::vector<Rotation> group{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    for (std::size_t i = 0; i < group.size(); ++i)
        for (const Rotation& generator : generators) {
            const Rotation next = product(generator, group[i]);
            bool known = false;
            for (const Rotation& one : group) known = known || equal(one, next);
            if (!known) group.push_back(next);
        }
    return group;
}

Rotation about_z(double cosine, double sine) { return {{{cosine, -sine, 0}, {sine, cosine, 0}, {0, 0, 1}}}; }

/// Rotations whose products leave a tensor of the class as it is.
std::vector<Rotation> generators_of(const std::string& symmetry) {
    const Rotation half_x{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}, half_z = about_z(-1, 0);
    const Rotation cyclic{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};  // a third of a turn about (1, 1, 1)
    const double root3 = std::sqrt(3.0), golden = (1 + std::sqrt(5.0)) / 2;
    const Rotation fifth{{{0.5, -golden / 2, 0.5 / golden}, {golden / 2, 0.5 / golden, -0.5}, {0.5 / golden, 0.5, golden / 2}}};
    if (symmetry == "triclinic") return {};
    if (symmetry == "monoclinic") return {half_z};
    if (symmetry == "orthotropic") return {half_x, half_z};
    if (symmetry == "trigonal") return {half_x, about_z(-0.5, root3 / 2)};
    if (symmetry == "tetragonal") return {half_x, about_z(0, 1)};
    if (symmetry == "transversely isotropic") return {half_x, about_z(0.5, root3 / 2)};
    if (symmetry == "cubic") return {half_x, about_z(0, 1), cyclic};
    if (symmetry == "isotropic") return {half_x, cyclic, fifth};
    throw std::invalid_argument("a class of elastic symmetry");
}

/// The mean of a matrix and its transpose.
Stiffness symmetric_part(const Stiffness& c) {
    Stiffness result{};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) result[i][j] = (c[i][j] + c[j][i]) / 2;
    return result;
}

}  // namespace

analytic::Point SeededNumbers::direction() {
    for (;;) {
        const analytic::Point p{symmetric(), symmetric(), symmetric()};  // in the ball: uniform on the sphere
        const double square = analytic::product(p, p);
        if (square > 1 || square < 0.01) continue;
        const double length = std::sqrt(square);
        return {p[0] / length, p[1] / length, p[2] / length};
    }
}

Stiffness random_stiffness(const std::string& symmetry, SeededNumbers& numbers) {
    const std::vector<Rotation> group = group_of(generators_of(symmetry));
    const Stiffness drawn = random_triclinic(numbers);
    Stiffness mean{};
    for (const Rotation& rotation : group) {
        const Stiffness turned = analytic::in_axes(drawn, rotation);
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j) mean[i][j] += turned[i][j] / static_cast<double>(group.size());
    }
    return symmetric_part(mean);
}

}  // namespace cleave::validation
