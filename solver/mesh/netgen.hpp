#pragma once

#include "solver/mesh/surface_mesh.hpp"
#include "solver/mesh/tet_mesh.hpp"

#include <string>

namespace cleave::mesh {

/// Tets of edge length `size` (m) at a surface and `inner_size` inside it (no larger than what the surface's triangles ask for), by the program cleave-netgen in a process of its own, so that NETGEN's aborts,
/// endless loops and chatter stay there. All tets in region 1; no surface triangles. Throws MeshingError where NETGEN fails, is killed
/// or runs longer than netgen::most_seconds, EnvironmentError where the program or a temporary folder is missing.
TetMesh mesh_by_netgen(const SurfaceMesh& surface, double size, double inner_size);

/// NETGEN's version, as its package states it.
std::string netgen_version();

}  // namespace cleave::mesh
