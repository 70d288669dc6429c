#include "solver/mesh/surface_marks.hpp"

#include "solver/mesh/surface_edges.hpp"
#include "solver/mesh/triangle_tree.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace cleave::mesh {
namespace {

/// cos of the largest angle between a boundary face and the input triangle it comes from.
constexpr double facing = 0.5;
constexpr double sharp_edge = 40 * std::numbers::pi / 180;

bool has_patches(const SurfaceMesh& surface) {
    return std::any_of(surface.triangles.begin(), surface.triangles.end(), [](const SurfaceTriangle& t) { return t.id != 0; });
}

std::vector<std::array<Eigen::Vector3d, 3>> corners_of(const SurfaceMesh& surface) {
    std::vector<std::array<Eigen::Vector3d, 3>> corners;
    for (const SurfaceTriangle& triangle : surface.triangles) {
        const auto [a, b, c] = triangle.vertices;
        corners.push_back({surface.vertices[a], surface.vertices[b], surface.vertices[c]});
    }
    return corners;
}

class PatchFinder {
public:
    explicit PatchFinder(const SurfaceMesh& surface) : surface_(surface), tree_(corners_of(surface)) {
        for (std::size_t i = 0; i < surface.triangles.size(); ++i) normals_.push_back(area_vector(surface, static_cast<int>(i)).normalized());
    }

    int patch(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const {
        const Eigen::Vector3d centre = (a + b + c) / 3, normal = (b - a).cross(c - a).normalized();
        int found = tree_.nearest(centre, [&](int i) { return normals_[i].dot(normal) >= facing; });
        if (found < 0) found = tree_.nearest(centre, [](int) { return true; });
        return surface_.triangles[found].id;
    }

private:
    const SurfaceMesh& surface_;
    TriangleTree tree_;
    std::vector<Eigen::Vector3d> normals_;
};

}  // namespace

std::vector<SurfaceTriangle> boundary_of(const TetMesh& mesh) {
    const HalfFaceLinks links = link_half_faces(mesh);
    std::vector<SurfaceTriangle> boundary;
    for (std::size_t half_face = 0; half_face < links.opposite.size(); ++half_face) {
        if (links.opposite[half_face] < 0) boundary.push_back({face_of(mesh.tets[half_face / 4], static_cast<int>(half_face % 4)), 1});
    }
    return boundary;
}

void mark_surface(TetMesh& mesh, const SurfaceMesh& surface) {
    mesh.surface = boundary_of(mesh);
    if (!has_patches(surface)) {
        mesh.surface_names = {{1, "outside"}};
        return;
    }
    const PatchFinder finder(surface);
    for (SurfaceTriangle& triangle : mesh.surface) {
        const auto [a, b, c] = triangle.vertices;
        triangle.id = finder.patch(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    }
    mesh.surface_names = surface.names;
}

void split_at_sharp_edges(SurfaceMesh& surface) {
    if (has_patches(surface)) return;
    const std::vector<std::array<int, 3>> beside = neighbours(surface);
    std::vector<int> patch(surface.triangles.size(), 0);
    int patches = 0;
    for (std::size_t seed = 0; seed < patch.size(); ++seed) {
        if (patch[seed] != 0) continue;
        std::vector<int> front{static_cast<int>(seed)};
        patch[seed] = ++patches;
        while (!front.empty()) {
            const int triangle = front.back();
            front.pop_back();
            const Eigen::Vector3d normal = area_vector(surface, triangle).normalized();
            for (const int other : beside[triangle]) {
                if (patch[other] != 0 || normal.dot(area_vector(surface, other).normalized()) < std::cos(sharp_edge)) continue;
                patch[other] = patches;
                front.push_back(other);
            }
        }
    }
    if (patches < 2) return;
    for (std::size_t i = 0; i < patch.size(); ++i) surface.triangles[i].id = patch[i];
}

}  // namespace cleave::mesh
