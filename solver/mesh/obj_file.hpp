#pragma once

#include "solver/mesh/surface_mesh.hpp"

#include <string>
#include <string_view>

namespace cleave::mesh {

/// Reads a Wavefront .obj: `v` rows (x y z; what follows is skipped), `f` rows of three or more corners (a, a/t, a//n, a/t/n;
/// negative numbers count from the end). Quads and polygons become a fan around the corner whose smallest triangle is largest (the first
/// such corner). Named groups (`g`, else `o`) that hold faces become patches 1, 2, ... where there are two or more.
/// Normals, textures, materials and smoothing are skipped; every other keyword is an error. Throws InputError with file and line. Does not call check_surface().
SurfaceMesh parse_obj(std::string_view text, const std::string& name);

/// The surface as .obj, %.17g coordinates, patches as groups: reading it back gives the same doubles.
std::string format_obj(const SurfaceMesh& surface);

}  // namespace cleave::mesh
