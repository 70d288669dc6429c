#include "solver/simulation/closest_point.hpp"

#include <algorithm>

namespace cleave::simulation {
namespace {

Eigen::Vector3d closest_on_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3d edge = b - a;
    const double length = edge.squaredNorm();
    const double t = length > 0 ? std::clamp((p - a).dot(edge) / length, 0.0, 1.0) : 0.0;
    return a + t * edge;
}

}  // namespace

Eigen::Vector3d closest_point(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    // Inside the prism over the triangle: the foot of the perpendicular; else the nearest of the three edges' points.
    const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
    const double d00 = ab.dot(ab), d01 = ab.dot(ac), d11 = ac.dot(ac), d20 = ap.dot(ab), d21 = ap.dot(ac);
    const double determinant = d00 * d11 - d01 * d01;
    if (determinant > 0) {
        const double v = (d11 * d20 - d01 * d21) / determinant, w = (d00 * d21 - d01 * d20) / determinant;
        if (v >= 0 && w >= 0 && v + w <= 1) return a + v * ab + w * ac;
    }
    Eigen::Vector3d best = closest_on_segment(p, a, b);
    for (const Eigen::Vector3d& other : {closest_on_segment(p, b, c), closest_on_segment(p, c, a)})
        if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
    return best;
}

}  // namespace cleave::simulation
