#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace cleave::subdivision {

using Triangle = std::array<Eigen::Vector3d, 3>;
using FlatTriangle = std::array<Eigen::Vector2d, 3>;

/// m^2. Written out, so that the order of rounding is fixed.
inline double triangle_area(const Triangle& triangle) {
    const Eigen::Vector3d u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
    const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
    return 0.5 * std::sqrt((x * x + y * y) + z * z);
}

/// Maps points of a face's plane to two dimensions, lengths kept.
class FaceFrame {
public:
    explicit FaceFrame(const Triangle& face);
    /// Counter-clockwise, whatever the order of the input.
    FlatTriangle flat(const Triangle& triangle) const;
    /// Back to space.
    Eigen::Vector3d lift(const Eigen::Vector2d& point) const { return origin_ + point[0] * first_ + point[1] * second_; }

private:
    Eigen::Vector3d origin_, first_, second_;
};

/// A convex polygon, counter-clockwise. Clipping a triangle by three lines gives at most six corners; rounding that bends it could
/// give nine (3 -> 4 -> 6 -> 9 if the signs alternate as often as they can).
struct FlatPolygon {
    std::array<Eigen::Vector2d, 9> corners;
    int count = 0;
    void add(const Eigen::Vector2d& corner) { corners[count++] = corner; }
};

/// The common part of two counter-clockwise triangles (Sutherland and Hodgman 1974: one clipped by the other's edges).
FlatPolygon overlap(const FlatTriangle& a, const FlatTriangle& b);

/// Its area, m^2.
double overlap_area(const FlatTriangle& a, const FlatTriangle& b);

}  // namespace cleave::subdivision
