#pragma once

#include <Eigen/Core>

#include <array>

namespace cleave::subdivision {

using Triangle = std::array<Eigen::Vector3d, 3>;
using FlatTriangle = std::array<Eigen::Vector2d, 3>;

/// m^2.
double triangle_area(const Triangle& triangle);

/// Maps points of a face's plane to two dimensions, lengths kept.
class FaceFrame {
public:
    explicit FaceFrame(const Triangle& face);
    /// Counter-clockwise, whatever the order of the input.
    FlatTriangle flat(const Triangle& triangle) const;

private:
    Eigen::Vector3d origin_, first_, second_;
};

/// Area of the common part of two counter-clockwise triangles, m^2 (Sutherland and Hodgman 1974: one clipped by the other's edges).
double overlap_area(const FlatTriangle& a, const FlatTriangle& b);

}  // namespace cleave::subdivision
