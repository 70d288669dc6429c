#include "solver/mesh/surface_edges.hpp"

#include <algorithm>

namespace cleave::mesh {

std::vector<HalfEdge> sorted_edges(const SurfaceMesh& surface) {
    std::vector<HalfEdge> edges;
    edges.reserve(3 * surface.triangles.size());
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        const auto& corners = surface.triangles[i].vertices;
        for (int edge = 0; edge < 3; ++edge) {
            const int from = corners[edge], to = corners[(edge + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), static_cast<int>(i), edge, from < to});
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

std::vector<std::array<int, 3>> neighbours(const SurfaceMesh& surface) {
    std::vector<std::array<int, 3>> beside(surface.triangles.size());
    const std::vector<HalfEdge> edges = sorted_edges(surface);
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
        beside[edges[i].triangle][edges[i].edge] = edges[i + 1].triangle;
        beside[edges[i + 1].triangle][edges[i + 1].edge] = edges[i].triangle;
    }
    return beside;
}

}  // namespace cleave::mesh
