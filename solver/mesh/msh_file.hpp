#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace cleave::mesh {

/// Reads a Gmsh .msh file, format 2.2 or 4.1, ASCII. Kept: 4-node tets with their first physical tag (0 without one), and
/// 3-node triangles that carry a physical tag; points, lines and other data sections are skipped; vertices no tet uses stay.
/// A volume or surface in several physical groups of 4.1 takes the first group. Coordinates are taken as metres.
/// Throws InputError with file and line: binary file, unknown format or version, a section cut short, unknown node, a number
/// that is not one, negative or impossible counts, elements of higher order, no tet at all. Does not call check().
TetMesh read_msh(const std::filesystem::path& path);

/// read_msh of text; `name` stands for the file in messages.
TetMesh parse_msh(std::string_view text, const std::string& name);

/// The mesh as Gmsh 2.2 ASCII text: %.17g coordinates, so that reading it back gives the same doubles. Surface triangles and
/// names are kept.
std::string format_msh(const TetMesh& mesh);

/// format_msh to a file, atomically. Throws EnvironmentError.
void write_msh(const TetMesh& mesh, const std::filesystem::path& path);

}  // namespace cleave::mesh
