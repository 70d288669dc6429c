#pragma once

#include "solver/mesh/surface_mesh.hpp"

#include <optional>
#include <utility>

namespace cleave::mesh {

/// The first two triangles (smallest numbers) of a closed manifold surface that meet elsewhere than in shared vertices and edges; exact
/// predicates (CGAL, Polygon_mesh_processing). None where the surface does not cut itself.
std::optional<std::pair<int, int>> intersecting_triangles(const SurfaceMesh& surface);

}  // namespace cleave::mesh
