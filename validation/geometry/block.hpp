#pragma once

#include "validation/geometry/shape.hpp"

namespace cleave::geometry {

ShapeInfo block_info();
/// A box from the origin to `extent`, meshed by Gmsh's Delaunay algorithm.
std::shared_ptr<const Shape> read_block(TableReader& geometry);

}  // namespace cleave::geometry
