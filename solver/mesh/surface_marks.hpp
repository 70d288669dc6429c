#pragma once

#include "solver/mesh/surface_mesh.hpp"
#include "solver/mesh/tet_mesh.hpp"

namespace cleave::mesh {

/// The faces of only one tet, outward, in the order of tets and faces, with id 1.
std::vector<SurfaceTriangle> boundary_of(const TetMesh& mesh);

/// Replaces the mesh's surface triangles by its whole boundary (boundary_of), each with the patch of the
/// nearest triangle of `surface` that faces the same way (within 60 degrees; the nearest of all where none does), with its name. A
/// surface without patches becomes patch 1, "outside".
void mark_surface(TetMesh& mesh, const SurfaceMesh& surface);

/// The patches of a closed surface that has none (all ids 0), parted by edges sharper than 40 degrees, numbered from 1 in the order of
/// their first triangle; left as it is where that is only one.
void split_at_sharp_edges(SurfaceMesh& surface);

}  // namespace cleave::mesh
