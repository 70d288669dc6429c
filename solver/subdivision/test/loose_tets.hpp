#pragma once

#include "solver/mesh/tet_mesh.hpp"
#include "solver/subdivision/test/random.hpp"

namespace cleave::subdivision::test {

/// `count` tets that share nothing, corners anywhere in [-1, 1]^3, a tenth of them slivers.
mesh::TetMesh loose_tets(Random& random, int count);

/// Cuts 250 loose tets by a random plane, `batches` times, and expects exact counts, volumes to 1e-14 L^3, none negative, links over
/// whole faces only. Returns how many tets were cut.
long cut_loose_tets(Random& random, int batches);

}  // namespace cleave::subdivision::test
