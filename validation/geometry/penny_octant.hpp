#pragma once

#include "validation/geometry/shape.hpp"

namespace cleave::geometry {

ShapeInfo penny_octant_info();
/// An eighth of a cube with a circular crack at its centre: 0 <= x, y, z <= half_width, left, front and `ligament` planes of symmetry. On
/// z = 0 lie `core` (r < load_radius, where a load may stand), `lips` (up to crack_radius) and `ligament`. Elements have size `size` at the
/// front, two to the load's radius at the core, and grow with the distance from both.
std::shared_ptr<const Shape> read_penny_octant(TableReader& geometry);

}  // namespace cleave::geometry
