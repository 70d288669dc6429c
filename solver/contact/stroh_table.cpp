#include "solver/contact/stroh_table.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleave::contact {

namespace {

/// (uv)_ik = C_ijks u_j v_s.
Eigen::Matrix3d contraction(const material::Stiffness& c, const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    static constexpr std::array<std::array<int, 3>, 3> row{{{0, 5, 4}, {5, 1, 3}, {4, 3, 2}}};
    Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j)
                for (int s = 0; s < 3; ++s) result(i, k) += c(row[i][j], row[k][s]) * u[j] * v[s];
    return result;
}

/// Changed so that no direction keeps a double root.
material::Stiffness parted(const material::Stiffness& stiffness) {
    material::Stiffness change;
    change << 1.0, 0.31, -0.17, 0.23, -0.11, 0.05,   //
        0.31, -0.7, 0.13, -0.29, 0.19, 0.37,         //
        -0.17, 0.13, 0.4, 0.07, -0.41, 0.21,         //
        0.23, -0.29, 0.07, 0.55, 0.15, -0.25,        //
        -0.11, 0.19, -0.41, 0.15, -0.35, 0.33,       //
        0.05, 0.37, 0.21, -0.25, 0.33, 0.6;
    return stiffness + 1e-8 * stiffness.diagonal().minCoeff() * change;
}

/// Smallest distance of two roots.
double least_gap(const StrohDirection& direction) {
    const auto& p = direction.root;
    return std::min({std::abs(p[0] - p[1]), std::abs(p[1] - p[2]), std::abs(p[2] - p[0])});
}

/// Ting (1996), Anisotropic Elasticity, Eqs. 5.5-4 to 5.5-8: N (a, b) = p (a, b), in units of the stiffness.
StrohDirection solve(const material::Stiffness& stiffness, double phi) {
    const double unit = stiffness.diagonal().maxCoeff();
    const material::Stiffness c = stiffness / unit;
    const Eigen::Vector3d m(std::cos(phi), std::sin(phi), 0), n = Eigen::Vector3d::UnitZ();
    const Eigen::Matrix3d Q = contraction(c, m, m), R = contraction(c, m, n), T = contraction(c, n, n), inverse = T.inverse();
    Eigen::Matrix<double, 6, 6> N;
    N << -inverse * R.transpose(), inverse, R * inverse * R.transpose() - Q, -R * inverse;
    const Eigen::EigenSolver<Eigen::Matrix<double, 6, 6>> eigen(N);
    StrohDirection direction{m[0], m[1], {}, {}};
    Eigen::Matrix3cd A, B;
    int found = 0;
    for (int k = 0; k < 6; ++k) {
        if (!(eigen.eigenvalues()[k].imag() > 0)) continue;
        if (found == 3) throw std::runtime_error("Stroh's eigenvalues in three conjugate pairs");
        direction.root[found] = eigen.eigenvalues()[k];
        A.col(found) = eigen.eigenvectors().col(k).head<3>();
        B.col(found++) = eigen.eigenvectors().col(k).tail<3>();
    }
    if (found != 3) throw std::runtime_error("Stroh's eigenvalues in three conjugate pairs");
    const Eigen::Matrix3cd rows = B.inverse();
    for (int k = 0; k < 3; ++k) direction.matrix[k] = A.col(k) * rows.row(k) / unit;
    return direction;
}

}  // namespace

StrohDirection stroh_direction(const material::Stiffness& stiffness, double phi) {
    const StrohDirection direction = solve(stiffness, phi);
    return least_gap(direction) > 1e-3 ? direction : solve(parted(stiffness), phi);
}

StrohTable::StrohTable(const material::Stiffness& stiffness, int most_directions) : stiffness_(stiffness) {
    do {
        levels_.push_back(std::make_unique<Level>());
    } while (2 * directions(levels() - 1) <= most_directions);
}

const StrohTable::Bounds& StrohTable::bounds() const {
    std::call_once(bounded_, [&] { bounds_ = find_bounds(); });
    return bounds_;
}

StrohTable::Bounds StrohTable::find_bounds() const {
    Bounds bounds;
    for (const StrohDirection& one : level(0))
        for (const auto& root : one.root) {
            bounds.least_decay = std::min(bounds.least_decay, root.imag());
            bounds.largest_shift = std::max(bounds.largest_shift, std::abs(root.real()));
        }
    // m + q t, t across m in the surface, is a complex direction (up to its length); it is singular where its own p is real, first of all
    // p = 0: q is a root of the surface's own plane. Turning m moves q along a circle about i, as far from i as ever (hyperbolic distance),
    // so one direction tells the smallest Im q of all.
    const Eigen::Matrix3d surface_upright = (Eigen::Matrix3d() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();
    for (const auto& q : stroh_direction(material::rotate_stiffness(stiffness_, surface_upright), 0).root)
        bounds.strip = std::min(bounds.strip, std::exp(-std::acosh(1 + std::norm(q - std::complex<double>(0, 1)) / (2 * q.imag()))));
    return bounds;
}

const std::vector<StrohDirection>& StrohTable::level(int level) const {
    Level& asked = *levels_[level];
    std::call_once(asked.made, [&] {
        const int half = directions(level) / 2;
        for (int k = 0; k < half; ++k) asked.directions.push_back(stroh_direction(stiffness_, M_PI * (k + 0.5) / half));
    });
    return asked.directions;
}

}  // namespace cleave::contact
