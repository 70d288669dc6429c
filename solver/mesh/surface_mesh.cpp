#include "solver/mesh/surface_mesh.hpp"

#include <Eigen/Geometry>

namespace cleave::mesh {

double enclosed_volume(const SurfaceMesh& surface) {
    if (surface.vertices.empty()) return 0;
    // Relative to a vertex: far from the origin the terms would cancel.
    const Eigen::Vector3d origin = surface.vertices.front();
    double sum = 0;
    for (const SurfaceTriangle& triangle : surface.triangles) {
        const auto [a, b, c] = triangle.vertices;
        sum += (surface.vertices[a] - origin).dot((surface.vertices[b] - origin).cross(surface.vertices[c] - origin));
    }
    return sum / 6;
}

Eigen::Vector3d area_vector(const SurfaceMesh& surface, int triangle) {
    const auto [a, b, c] = surface.triangles[static_cast<std::size_t>(triangle)].vertices;
    return 0.5 * (surface.vertices[b] - surface.vertices[a]).cross(surface.vertices[c] - surface.vertices[a]);
}

double total_area(const SurfaceMesh& surface) {
    double sum = 0;
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) sum += area_vector(surface, static_cast<int>(i)).norm();
    return sum;
}

}  // namespace cleave::mesh
