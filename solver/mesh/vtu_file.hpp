#pragma once

#include "solver/mesh/surface_mesh.hpp"
#include "solver/mesh/tet_mesh.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace cleave::mesh {

/// Reads a VTK XML unstructured grid (.vtu) of one piece: linear tets (type 10) and triangles (5); vertices and lines are skipped, other cells are an
/// error. Data as ASCII, base64, or appended (raw or base64), little-endian, plain or zlib. Whole numbers of the cell array "region" (else "gmsh:physical",
/// else "CellEntityIds") give regions and the triangles' patches. Tets give a TetMesh, triangles alone a SurfaceMesh.
/// Throws InputError (file, line). No checks of shape.
std::variant<TetMesh, SurfaceMesh> parse_vtu(std::string_view bytes, const std::string& name);

/// The tets as ASCII .vtu with the cell array "region", %.17g coordinates; names and surface triangles get lost.
std::string format_vtu(const TetMesh& mesh);

}  // namespace cleave::mesh
