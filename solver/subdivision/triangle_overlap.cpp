#include "solver/subdivision/triangle_overlap.hpp"

#include <Eigen/Geometry>

#include <utility>

namespace cleave::subdivision {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a[0] * b[1] - a[1] * b[0]; }

/// The part of the polygon on the left of the line from a to b.
FlatPolygon clip(const FlatPolygon& polygon, const Vector2d& a, const Vector2d& b) {
    FlatPolygon kept;
    for (int i = 0; i < polygon.count; ++i) {
        const Vector2d& here = polygon.corners[i];
        const Vector2d& next = polygon.corners[(i + 1) % polygon.count];
        const double d_here = cross(b - a, here - a), d_next = cross(b - a, next - a);
        if (d_here >= 0) kept.add(here);
        if ((d_here >= 0) != (d_next >= 0)) kept.add(here + d_here / (d_here - d_next) * (next - here));
    }
    return kept;
}

double area(const FlatPolygon& polygon) {
    double twice = 0;
    for (int i = 1; i + 1 < polygon.count; ++i) {
        twice += cross(polygon.corners[i] - polygon.corners[0], polygon.corners[i + 1] - polygon.corners[0]);
    }
    return 0.5 * twice;
}

}  // namespace

FaceFrame::FaceFrame(const Triangle& face) : origin_(face[0]), first_((face[1] - face[0]).normalized()) {
    const Eigen::Vector3d side = face[2] - face[0];
    second_ = (side - first_.dot(side) * first_).normalized();
}

FlatTriangle FaceFrame::flat(const Triangle& triangle) const {
    FlatTriangle flat;
    for (int i = 0; i < 3; ++i) flat[i] = {first_.dot(triangle[i] - origin_), second_.dot(triangle[i] - origin_)};
    if (cross(flat[1] - flat[0], flat[2] - flat[0]) < 0) std::swap(flat[1], flat[2]);
    return flat;
}

FlatPolygon overlap(const FlatTriangle& a, const FlatTriangle& b) {
    FlatPolygon polygon;
    for (const Vector2d& corner : a) polygon.add(corner);
    for (int i = 0; i < 3; ++i) polygon = clip(polygon, b[i], b[(i + 1) % 3]);
    return polygon;
}

double overlap_area(const FlatTriangle& a, const FlatTriangle& b) { return area(overlap(a, b)); }

}  // namespace cleave::subdivision
