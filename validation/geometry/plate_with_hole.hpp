#pragma once

#include "validation/geometry/shape.hpp"

namespace cleave::geometry {

ShapeInfo plate_with_hole_info();
/// A square plate, |x|, |y| <= half_width, 0 <= z <= thickness, with a circular hole about the z axis; or its quarter x, y >= 0.
/// A graded triangulation is swept through the thickness in `layers` layers, each prism cut into three tets.
/// The size at radius r: size/20 at the four poles of the rim, growing by 0.12 per unit of distance to at most size/3 on the
/// rest of it, size from 2 hole radii to 3, then growing by 0.3 per unit of distance.
std::shared_ptr<const Shape> read_plate_with_hole(TableReader& geometry);

}  // namespace cleave::geometry
