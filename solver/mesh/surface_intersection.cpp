#include "solver/mesh/surface_intersection.hpp"

// CGAL stays in this one file: it is slow to compile.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace cleave::mesh {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Surface converted(const SurfaceMesh& from) {
    Surface surface;
    for (const Eigen::Vector3d& x : from.vertices) surface.add_vertex(Kernel::Point_3(x[0], x[1], x[2]));
    for (const SurfaceTriangle& triangle : from.triangles) {
        const auto vertex = [&](int i) { return Surface::Vertex_index(static_cast<Surface::size_type>(triangle.vertices[i])); };
        surface.add_face(vertex(0), vertex(1), vertex(2));
    }
    return surface;
}

}  // namespace

std::optional<std::pair<int, int>> intersecting_triangles(const SurfaceMesh& from) {
    const Surface surface = converted(from);
    std::vector<std::pair<Surface::Face_index, Surface::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(found));
    if (found.empty()) return std::nullopt;
    std::pair<int, int> first{static_cast<int>(from.triangles.size()), 0};
    for (const auto& [one, two] : found) {
        const int i = static_cast<int>(one.idx()), j = static_cast<int>(two.idx());
        first = std::min(first, {std::min(i, j), std::max(i, j)});
    }
    return first;
}

}  // namespace cleave::mesh
