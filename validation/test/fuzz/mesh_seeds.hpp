#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <string>
#include <vector>

namespace cleave::fuzz {

/// Two tets that share a face, with regions, a marked surface and names.
mesh::TetMesh two_tets();

/// It as .msh 2.2, and a file of format 4.1.
std::vector<std::string> msh_seeds();

}  // namespace cleave::fuzz
