#pragma once

#include "solver/mesh/surface_mesh.hpp"

#include <string>
#include <string_view>

namespace cleave::mesh {

/// Reads an STL file, ASCII ("solid", "facet normal", "outer loop", "vertex", ...) or binary (80 bytes of header, a count, 50 bytes a facet;
/// told apart by the length that the count implies). Corners at exactly one point become one vertex; the normals are not used. Several
/// solids of an ASCII file become patches 1, 2, ..., by name. Throws InputError (file; line where ASCII) for a file cut short or longer than its count, a number that is not
/// finite, no facet. Does not call check_surface().
SurfaceMesh parse_stl(std::string_view bytes, const std::string& name);

}  // namespace cleave::mesh
