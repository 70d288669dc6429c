#pragma once

#include "validation/geometry/shape.hpp"

namespace cleave::geometry {

/// A strip of layers stacked along z, from the origin to (length, width, sum of thicknesses): regions odd (first, third, ... layer) and
/// even. A line across the bottom at x = support splits it into bottom_outer and bottom_inner.
ShapeInfo layered_strip_info();
std::shared_ptr<const Shape> read_layered_strip(TableReader& geometry);

}  // namespace cleave::geometry
