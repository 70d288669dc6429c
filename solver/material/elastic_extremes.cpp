#include "solver/material/elastic_extremes.hpp"

#include "solver/material/stiffness.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace cleave::material {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

/// Polar angle and azimuth of the first direction, and the angle of the second about it.
using Angles = Vector3d;
using Function = std::function<double(const Angles&)>;

Vector3d first_of(const Angles& a) { return {std::sin(a[0]) * std::cos(a[1]), std::sin(a[0]) * std::sin(a[1]), std::cos(a[0])}; }

Vector3d second_of(const Angles& a) {
    const Vector3d south(std::cos(a[0]) * std::cos(a[1]), std::cos(a[0]) * std::sin(a[1]), -std::sin(a[0]));
    const Vector3d east(-std::sin(a[1]), std::cos(a[1]), 0);
    return std::cos(a[2]) * south + std::sin(a[2]) * east;
}

Voigt dyad(const Vector3d& a, const Vector3d& b) { return stress_to_voigt(0.5 * (a * b.transpose() + b * a.transpose())); }

/// Compass search: steps along the angles, halved where none of them helps.
Angles refined(const Function& f, Angles at, int count, double step) {
    double best = f(at);
    while (step > 1e-8) {
        bool better = false;
        for (int k = 0; k < count; ++k)
            for (const double sign : {1.0, -1.0}) {
                Angles next = at;
                next[k] += sign * step;
                if (const double value = f(next); value < best) best = value, at = next, better = true;
            }
        if (!better) step *= 0.5;
    }
    return at;
}

struct Candidate {
    double value;
    Angles at;
};

/// The smallest value: a grid over half of all directions (opposite ones are alike), then the best eight of it refined.
Angles smallest(const Function& f, int count) {
    constexpr int polar = 45, azimuth = 45, about = 45;  // steps of 4 degrees
    const double step = pi / polar;
    std::vector<Candidate> grid;
    for (int i = 0; i <= polar; ++i)
        for (int j = 0; j < azimuth; ++j)
            for (int k = 0; k < (count == 3 ? about : 1); ++k) {
                const Angles at(i * step, j * step, k * step);
                grid.push_back({f(at), at});
            }
    const std::size_t kept = std::min<std::size_t>(8, grid.size());
    std::partial_sort(grid.begin(), grid.begin() + static_cast<std::ptrdiff_t>(kept), grid.end(),
                      [](const Candidate& a, const Candidate& b) { return a.value < b.value; });
    Angles best = grid.front().at;
    for (std::size_t i = 0; i < kept; ++i)
        if (const Angles at = refined(f, grid[i].at, count, step / 2); f(at) < f(best)) best = at;
    return best;
}

Extremes extremes(const Function& f, int count) {
    const auto found = [&](double sign) {
        const Angles at = smallest([&](const Angles& a) { return sign * f(a); }, count);
        return Extreme{f(at), first_of(at), count == 3 ? second_of(at) : Vector3d(Vector3d::Zero())};
    };
    return {found(1), found(-1)};
}

}  // namespace

Extremes youngs_modulus_extremes(const Stiffness& stiffness) {
    const Stiffness s = compliance(stiffness);
    return extremes(
        [&](const Angles& a) {
            const Voigt n = dyad(first_of(a), first_of(a));
            return 1 / n.dot(s * n);
        },
        2);
}

Extremes shear_modulus_extremes(const Stiffness& stiffness) {
    const Stiffness s = compliance(stiffness);
    return extremes(
        [&](const Angles& a) {
            const Voigt pair = dyad(first_of(a), second_of(a));
            return 1 / (4 * pair.dot(s * pair));
        },
        3);
}

Extremes poisson_ratio_extremes(const Stiffness& stiffness) {
    const Stiffness s = compliance(stiffness);
    return extremes(
        [&](const Angles& a) {
            const Voigt load = dyad(first_of(a), first_of(a)), across = dyad(second_of(a), second_of(a));
            const Voigt strain = s * load;
            return -across.dot(strain) / load.dot(strain);
        },
        3);
}

Vector3d wave_speeds(const Stiffness& stiffness, double density, const Vector3d& direction) {
    if (!(density > 0)) throw std::invalid_argument("a density above zero");
    const Vector3d n = direction.normalized();
    Matrix3d christoffel;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            // Gamma_ik = n_j C_ijkl n_l: the stress of the strain sym(e_k n), read at (i, n).
            const Voigt strain = strain_to_voigt(0.5 * (Vector3d::Unit(k) * n.transpose() + n * Vector3d::Unit(k).transpose()));
            christoffel(i, k) = stress_from_voigt(stiffness * strain).row(i).dot(n);
        }
    return (Eigen::SelfAdjointEigenSolver<Matrix3d>(christoffel, Eigen::EigenvaluesOnly).eigenvalues() / density).cwiseSqrt();
}

}  // namespace cleave::material
