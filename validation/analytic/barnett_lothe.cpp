#include "validation/analytic/barnett_lothe.hpp"

#include <cmath>
#include <numbers>

namespace cleave::analytic {

namespace {

Point cross(const Point& a, const Point& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }

Point combine(double s, const Point& a, double t, const Point& b) {
    return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}

/// A unit vector normal to `axis`: the coordinate axis farthest from it, made orthogonal.
Point normal_to(const Point& axis) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(axis[i]) < std::abs(axis[least])) least = i;
    Point e{};
    e[least] = 1;
    const Point n = cross(axis, e);
    return combine(1 / std::sqrt(product(n, n)), n, 0, n);
}

Matrix product_of(const Matrix& a, const Matrix& b) {
    Matrix result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
    return result;
}

constexpr int nodes = 256;

}  // namespace

Matrix contracted(const Stiffness& c, const Point& a, const Point& b) {
    Matrix result{};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j)
                for (int l = 0; l < 3; ++l)
                    result[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] +=
                        component(c, i, j, k, l) * a[static_cast<std::size_t>(j)] * b[static_cast<std::size_t>(l)];
    return result;
}

double product(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point times(const Matrix& matrix, const Point& vector) { return {product(matrix[0], vector), product(matrix[1], vector), product(matrix[2], vector)}; }

Matrix inverse(const Matrix& m) {
    const Point a = cross(m[1], m[2]), b = cross(m[2], m[0]), c = cross(m[0], m[1]);
    const double determinant = product(m[0], a);
    Matrix result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = {a[i] / determinant, b[i] / determinant, c[i] / determinant};
    return result;
}

CrackAxes axes_about(const Point& last) {
    const Point first = normal_to(last);
    return {first, cross(last, first), last};
}

Stiffness in_axes(const Stiffness& stiffness, const CrackAxes& axes) {
    constexpr int first[6] = {0, 1, 2, 1, 0, 0}, second[6] = {0, 1, 2, 2, 2, 1};
    Stiffness turned{};
    for (std::size_t I = 0; I < 6; ++I)
        for (std::size_t J = 0; J < 6; ++J)
            for (int p = 0; p < 3; ++p)
                for (int q = 0; q < 3; ++q)
                    for (int r = 0; r < 3; ++r)
                        for (int s = 0; s < 3; ++s)
                            turned[I][J] += axes[static_cast<std::size_t>(first[I])][static_cast<std::size_t>(p)] *
                                            axes[static_cast<std::size_t>(second[I])][static_cast<std::size_t>(q)] *
                                            axes[static_cast<std::size_t>(first[J])][static_cast<std::size_t>(r)] *
                                            axes[static_cast<std::size_t>(second[J])][static_cast<std::size_t>(s)] * component(stiffness, p, q, r, s);
    return turned;
}

Matrix barnett_lothe(const Stiffness& stiffness, const Point& front) {
    const auto [first, second, along] = axes_about(front);
    Matrix sum{};
    for (int node = 0; node < nodes; ++node) {
        const double phi = 2 * std::numbers::pi * node / nodes;
        const Point m = combine(std::cos(phi), first, std::sin(phi), second), n = combine(-std::sin(phi), first, std::cos(phi), second);
        const Matrix mm = contracted(stiffness, m, m), mn = contracted(stiffness, m, n), nm = contracted(stiffness, n, m);
        const Matrix drop = product_of(mn, product_of(inverse(contracted(stiffness, n, n)), nm));
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) sum[i][j] += (mm[i][j] - drop[i][j]) / nodes;
    }
    return sum;
}

double energy_release(const Stiffness& stiffness, const CrackAxes& axes, const Point& intensities) {
    const Matrix compliance = inverse(barnett_lothe(in_axes(stiffness, axes), {0, 0, 1}));
    return product(intensities, times(compliance, intensities)) / 2;
}

AnisotropicPenny::AnisotropicPenny(const Stiffness& stiffness, const Point& normal, double radius, const Point& traction)
    : stiffness_(stiffness), radius_(radius), traction_(traction) {
    const auto [first, second, across] = axes_about(normal);
    constexpr int directions = 180;  // L of the opposite direction is the same
    Matrix mean{};
    for (int d = 0; d < directions; ++d) {
        const double angle = std::numbers::pi * d / directions;
        const Matrix l = barnett_lothe(stiffness, combine(std::cos(angle), first, std::sin(angle), second));
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) mean[i][j] += l[i][j] / directions;
    }
    opening_ = times(inverse(mean), traction);
}

Point AnisotropicPenny::intensities(const CrackAxes& axes) const {
    const Point k = times(barnett_lothe(stiffness_, axes[2]), opening_);
    const double factor = 2 * std::sqrt(radius_ / std::numbers::pi);
    return {factor * product(axes[0], k), factor * product(axes[1], k), factor * product(axes[2], k)};
}

double AnisotropicPenny::mean_energy_release() const { return 2 * radius_ / std::numbers::pi * product(traction_, opening_); }

}  // namespace cleave::analytic
