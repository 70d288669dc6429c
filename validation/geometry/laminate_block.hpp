#pragma once

#include "validation/geometry/shape.hpp"

namespace cleave::geometry {

ShapeInfo laminate_block_info();
/// A box from the origin to `extent`, cut at z = `interface` into the regions `lower` and `upper`; the mesh conforms to the interface.
std::shared_ptr<const Shape> read_laminate_block(TableReader& geometry);

}  // namespace cleave::geometry
