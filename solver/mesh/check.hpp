#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <string>

namespace cleave::mesh {

/// Throws InputError (naming `file`, and the tet or vertex at fault, numbered from 1) for: no tet, a coordinate that is not
/// finite, a vertex number out of range, a vertex twice in a tet, an inverted or flat tet (|volume| <= 1e-14 of its longest edge
/// cubed; its volume is printed), the same tet twice, a face shared by three tets, a region list of another length.
/// Unused vertices are allowed.
void check(const TetMesh& mesh, const std::string& file);

}  // namespace cleave::mesh
