#pragma once

#include "validation/geometry/shape.hpp"

namespace cleave::geometry {

/// A quarter of a plate between two ellipses about z, of NAFEMS LE1 and LE10: x, y >= 0, 0 <= z <= thickness. Tets are graded to the
/// inner ellipse's end on the x axis. The mid-plane splits the outer surface, so that a line of nodes lies there.
ShapeInfo elliptic_plate_info();
std::shared_ptr<const Shape> read_elliptic_plate(TableReader& geometry);

}  // namespace cleave::geometry
