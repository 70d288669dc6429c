#pragma once

#include "solver/mesh/surface_mesh.hpp"
#include "solver/mesh/tet_mesh.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace cleave::mesh {

/// Reads a Medit .mesh file (ASCII): Vertices, Tetrahedra and Triangles with their reference numbers; other sections are skipped.
/// Tets give a TetMesh (reference = region; triangles with a reference other than 0 = tagged surface), triangles alone a SurfaceMesh.
/// Throws InputError with file and line: dimension other than 3, counts that do not fit, unknown vertices, nothing to mesh. No checks of shape.
std::variant<TetMesh, SurfaceMesh> parse_medit(std::string_view text, const std::string& name);

/// The mesh as Medit ASCII, %.17g coordinates; names get lost.
std::string format_medit(const TetMesh& mesh);

}  // namespace cleave::mesh
