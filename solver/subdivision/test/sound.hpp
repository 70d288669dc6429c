#pragma once

#include "solver/mesh/tet_mesh.hpp"
#include "solver/subdivision/subdivided.hpp"

namespace cleave::subdivision::test {

/// Expects what must hold for every subdivision with tau = 0.1: exact counts, a mesh that passes the checks, volumes to 1e-14 L^3,
/// every face with one partner or overlaps that sum to its area to 1e-12, links symmetric, no child below 1e-4 of its parent.
void expect_sound(const mesh::TetMesh& mesh, const Subdivided& out);

}  // namespace cleave::subdivision::test
