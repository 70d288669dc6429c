#pragma once

#include "solver/mesh/tet_mesh.hpp"
#include "solver/subdivision/subdivided.hpp"

#include <vector>

namespace cleave::subdivision {

/// The original's tagged triangles; those on faces that were cut are replaced by their pieces, in the triangle's own orientation.
/// tets, parent, cut and parent_face of `out` must be filled.
std::vector<mesh::SurfaceTriangle> cut_surface(const mesh::TetMesh& original, const Subdivided& out);

}  // namespace cleave::subdivision
