#pragma once

#include "solver/mesh/surface_mesh.hpp"
#include "solver/mesh/tet_mesh.hpp"

namespace cleave::mesh {

/// Tets inside a surface by Gmsh, edges about `size` long inside (m); the surface's own triangles stay as they are (Gmsh 4.8 cannot
/// make those of a curved surface anew without tangling them). All tets in region 1. Throws MeshingError.
TetMesh mesh_by_gmsh(const SurfaceMesh& surface, double size);

}  // namespace cleave::mesh
