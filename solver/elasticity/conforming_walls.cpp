#include "solver/elasticity/conforming_walls.hpp"

#include <cmath>

namespace cleave::elasticity {

namespace {

/// Walls count as larger by this part of their size.
constexpr double overhang = 1e-6;
/// A crossing nearer to the eye than this part of the segment is the eye's own wall.
constexpr double own_wall = 1e-9;

using Triangle = std::array<Eigen::Vector3d, 3>;

std::vector<Triangle> wall_triangles(const mesh::TetMesh& mesh, const FaceSet& faces, const std::vector<char>& opaque) {
    std::vector<Triangle> triangles;
    for (std::size_t half = 0; half < faces.of_half_face.size(); ++half) {
        const int face = faces.of_half_face[half], tet = static_cast<int>(half / 4);
        if (!opaque[face] || faces.faces[face].inside != tet) continue;
        const auto [a, b, c] = mesh::face_of(mesh.tets[tet], static_cast<int>(half % 4));
        triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    }
    return triangles;
}

std::vector<Box> boxes_of(const std::vector<Triangle>& triangles) {
    std::vector<Box> boxes;
    for (const Triangle& triangle : triangles) {
        Box box;
        for (const Eigen::Vector3d& vertex : triangle) box.extend(vertex);
        const Eigen::Vector3d margin = Eigen::Vector3d::Constant(overhang * box.diagonal().norm());
        boxes.emplace_back(box.min() - margin, box.max() + margin);
    }
    return boxes;
}

}  // namespace

Walls::Walls(const mesh::TetMesh& mesh, const FaceSet& faces, const std::vector<char>& opaque)
    : triangles_(wall_triangles(mesh, faces, opaque)), tree_(boxes_of(triangles_)) {}

std::vector<int> Walls::near(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const { return tree_.touching(Box(low, high)); }

bool Walls::visible(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, const std::vector<int>& walls) const {
    for (const int wall : walls)
        if (blocks(triangles_[wall], eye, target)) return false;
    return true;
}

bool Walls::blocks(const std::array<Eigen::Vector3d, 3>& wall, const Eigen::Vector3d& eye, const Eigen::Vector3d& target) const {
    // Moeller and Trumbore 1997: eye + t (target - eye) = a + v (b - a) + w (c - a).
    const Eigen::Vector3d ray = target - eye, ab = wall[1] - wall[0], ac = wall[2] - wall[0], from = eye - wall[0];
    const Eigen::Vector3d p = ray.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0) return false;  // the segment runs along the wall
    const double v = from.dot(p) / determinant;
    const Eigen::Vector3d q = from.cross(ab);
    const double w = ray.dot(q) / determinant, t = ac.dot(q) / determinant;
    return v >= -overhang && w >= -overhang && v + w <= 1 + overhang && t > own_wall && t < 1;
}

}  // namespace cleave::elasticity
