#pragma once

#include "solver/mesh/surface_mesh.hpp"
#include "solver/mesh/tet_mesh.hpp"

#include <filesystem>
#include <string>
#include <vector>
#include <variant>

namespace cleave::mesh {

/// What a user's file holds: tets, or a surface that has to be meshed.
using Imported = std::variant<TetMesh, SurfaceMesh>;

/// Reads by the file's ending; coordinates are taken as metres:
/// .msh  tets (Gmsh 2.2, 4.1, ASCII)
/// .mesh tets, or triangles where there are none (Medit, ASCII)
/// .vtu  tets, or triangles where there are none (VTK XML: ASCII, base64, appended; zlib)
/// .stl  triangles (ASCII or binary; equal points become one vertex)
/// .obj  triangles and quads (groups become patches)
/// Tets that a file other than .msh gives inverted throughout are turned over; a mixture is an error. A surface without patches is parted at
/// its sharp edges (split_at_sharp_edges). Throws InputError (file, line
/// where there is one, what was expected). Tets have passed check(), surfaces check_surface().
Imported import_mesh(const std::filesystem::path& file);

/// The endings import_mesh knows, with the dot.
const std::vector<std::string>& import_endings();

}  // namespace cleave::mesh
