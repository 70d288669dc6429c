#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cleave::particles {

/// Lengths, and other measures, nearer to each other than this part of their size are equal: on lattices and in mirrored bodies they are but for rounding, and the
/// rounding of a centroid depends on the order in which a tet lists its vertices.
inline constexpr double alike = 1e-9;

/// By coordinates, those that differ by at most `rounding` (m) being equal: the order that settles what is equal otherwise, and that no
/// numbering changes.
inline bool comes_before(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double rounding) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(a[axis] - b[axis]) > rounding) return a[axis] < b[axis];
    return false;
}

/// Whether a is nearer to the point than b; of equally near places the one that comes_before.
inline bool is_nearer(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double to_a = (a - point).norm(), to_b = (b - point).norm(), rounding = alike * std::max(to_a, to_b);
    return std::abs(to_a - to_b) > rounding ? to_a < to_b : comes_before(a, b, rounding);
}

/// Index of the place nearest to a point (is_nearer), among one or more.
inline int nearest_place(const std::vector<Eigen::Vector3d>& places, const Eigen::Vector3d& point) {
    const auto nearer = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return is_nearer(point, a, b); };
    return static_cast<int>(std::min_element(places.begin(), places.end(), nearer) - places.begin());
}

}  // namespace cleave::particles
