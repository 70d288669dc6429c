#pragma once

#include "validation/geometry/shape.hpp"

namespace cleave::geometry {

ShapeInfo imported_info();
/// A user's own .msh file, read as it is: `mesh = "file.msh"`, relative to the current folder or to the case file. Surfaces and
/// regions are called by their names in the file, or by their tags ("12"). The ladder has one size: that of the mesh.
std::shared_ptr<const Shape> read_imported(TableReader& geometry);

}  // namespace cleave::geometry
