#pragma once

#include "solver/mesh/surface_mesh.hpp"

#include <string>

namespace cleave::mesh {

/// What a mesher needs of a surface; NETGEN aborts and others mesh wrongly without it. Throws InputError (one line: `file`, the
/// triangle or vertex at fault, numbered from 1) for the first of: no triangle, a coordinate that is not finite, a vertex number out
/// of range, a triangle without area, two vertices at one point (not welded), the same triangle twice, an edge of one triangle (open) or
/// of three (not manifold), neighbours of opposite orientation, a vertex where two sheets touch, more than one shell, a surface that
/// is inside out, triangles that intersect (exact predicates).
void check_surface(const SurfaceMesh& surface, const std::string& file);

}  // namespace cleave::mesh
