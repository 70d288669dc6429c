#pragma once

#include "validation/geometry/shape.hpp"

namespace cleave::geometry {

ShapeInfo imported_info();
/// A user's own file, `mesh = "file"`, relative to the current folder or to the case file (formats: mesh::import_mesh). Surfaces and regions
/// are called by their names in the file, or by their tags ("12").
/// Tets are taken as they are, and the ladder has one size: that of the mesh. A surface (.stl, .obj, ...) is meshed at the ladder's sizes by
/// `mesher` = "netgen" (default) or "gmsh" (which keeps the file's triangles); its longest side is `relative_to = "extent"`.
std::shared_ptr<const Shape> read_imported(TableReader& geometry);

}  // namespace cleave::geometry
