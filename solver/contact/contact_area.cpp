#include "solver/contact/contact_area.hpp"

#include "solver/contact/contact_load.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::contact {

namespace {

using Point = Eigen::Vector2d;
using Polygon = std::vector<Point>;  // convex, counter-clockwise

double cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Hull by Andrew's chains.
Polygon convex_hull(Polygon points) {
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return std::pair(a[0], a[1]) < std::pair(b[0], b[1]); });
    Polygon hull;
    const auto add = [&hull](const Point& p, std::size_t least) {
        while (hull.size() >= least && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) hull.pop_back();
        hull.push_back(p);
    };
    for (const Point& p : points) add(p, 2);
    const std::size_t lower = hull.size() + 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
    hull.pop_back();
    return hull;
}

Polygon shadow(const Tet& tet, const Eigen::Matrix3d& axes) {
    Polygon points;
    for (const Eigen::Vector3d& corner : tet) points.push_back((axes.transpose() * corner).head<2>());
    return convex_hull(std::move(points));
}

/// The part of a convex polygon to the left of a -> b (Sutherland and Hodgman 1974).
Polygon clip(const Polygon& polygon, const Point& a, const Point& b) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double dp = cross(b - a, p - a), dq = cross(b - a, q - a);
        if (dp >= 0) kept.push_back(p);
        if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) kept.push_back(p + dp / (dp - dq) * (q - p));
    }
    return kept;
}

double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return 0.5 * twice;
}

}  // namespace

Tet corners_of(const mesh::TetMesh& mesh, int tet) {
    Tet corners;
    for (int k = 0; k < 4; ++k) corners[k] = mesh.vertices[mesh.tets[tet][k]];
    return corners;
}

double shadow_overlap_area(const Tet& first, const Tet& second, const Eigen::Vector3d& normal) {
    const Eigen::Matrix3d axes = surface_axes(normal);
    Polygon overlap = shadow(first, axes);
    const Polygon window = shadow(second, axes);
    for (std::size_t i = 0; i < window.size() && !overlap.empty(); ++i) overlap = clip(overlap, window[i], window[(i + 1) % window.size()]);
    return area(overlap);
}

double hertz_contact_area(const HertzContact& contact) { return M_PI * contact.radius * contact.radius; }

double hertz_contact_area(const EllipticalContact& contact) { return M_PI * contact.major * contact.minor; }

}  // namespace cleave::contact
