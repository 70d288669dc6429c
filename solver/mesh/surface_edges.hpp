#pragma once

#include "solver/mesh/surface_mesh.hpp"

#include <array>
#include <compare>
#include <vector>

namespace cleave::mesh {

/// One side of an edge: vertices low < high, the triangle, its edge (from local vertex `edge` to the next), and whether the triangle
/// runs along it from low to high.
struct HalfEdge {
    int low, high;
    int triangle, edge;
    bool ascending;
    friend auto operator<=>(const HalfEdge&, const HalfEdge&) = default;
};

/// All three edges of all triangles, sorted: the triangles at an edge stand together.
std::vector<HalfEdge> sorted_edges(const SurfaceMesh& surface);

/// Per triangle its neighbours across edges (0, 1), (1, 2), (2, 0). The surface must be closed and manifold.
std::vector<std::array<int, 3>> neighbours(const SurfaceMesh& surface);

}  // namespace cleave::mesh
