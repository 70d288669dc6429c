#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <array>

namespace cleave::mesh::test {

/// The unit cube as cells^3 boxes of six tets each (Kuhn's triangulation: conforming by construction). Vertices are moved by
/// `shake` times the box size in a fixed pattern, inside ones only.
TetMesh kuhn_cube(int cells, double shake = 0);

/// The tet with vertices 0, e_x, e_y, e_z, of volume 1/6.
TetMesh unit_tet();

}  // namespace cleave::mesh::test
