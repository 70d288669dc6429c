#pragma once

#include "solver/mesh/surface_mesh.hpp"
#include "solver/mesh/tet_mesh.hpp"

#include <array>

namespace cleave::mesh::test {

/// The unit cube as cells^3 boxes of six tets each (Kuhn's triangulation: conforming by construction). Vertices are moved by
/// `shake` times the box size in a fixed pattern, inside ones only.
TetMesh kuhn_cube(int cells, double shake = 0);

/// The tet with vertices 0, e_x, e_y, e_z, of volume 1/6.
TetMesh unit_tet();

/// The unit cube's surface: 8 vertices (number = x + 2 y + 4 z), 12 triangles outward, two by two: left, right, front, back, bottom, top.
SurfaceMesh cube_surface();

/// The unit sphere as an octahedron whose triangles are quartered `rounds` times, vertices on the sphere: 8 * 4^rounds triangles.
SurfaceMesh sphere_surface(int rounds);

}  // namespace cleave::mesh::test
