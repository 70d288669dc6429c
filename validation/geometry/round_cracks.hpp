#pragma once

#include "validation/geometry/shape.hpp"

/// Boxes with one crack whose front is an ellipse or a circle, or part of one. Their meshes are those of cracked_box.hpp: elements have
/// size `size` at the front and grow by grading sqrt(size / a) (grading 0.8 unless given) per unit of distance from it, a the crack's radius (or its shorter half axis):
/// halving `size` multiplies the tets by four.
namespace cleave::geometry {

ShapeInfo penny_crack_block_info();
/// A cube, |x|, |y|, |z| <= half_width, with a circular crack about its centre: the crack's normal is z turned by crack_angle about y.
std::shared_ptr<const Shape> read_penny_crack_block(TableReader& geometry);

ShapeInfo elliptical_crack_block_info();
/// The same with an ellipse, half axes half_axis_x >= half_axis_y along x (turned by crack_angle about y) and y.
std::shared_ptr<const Shape> read_elliptical_crack_block(TableReader& geometry);

ShapeInfo cap_crack_block_info();
/// The same with a cap of a sphere: its front is the circle of radius crack_radius about the origin in the plane whose normal is z turned
/// by crack_angle about y; the cap rises above it, opening_angle from its pole to the front as seen from the sphere's centre.
std::shared_ptr<const Shape> read_cap_crack_block(TableReader& geometry);

ShapeInfo corner_crack_block_info();
/// 0 <= x, y <= width, |z| <= half_height, with the quarter of a circular crack about the origin that lies inside: normal z turned by
/// crack_angle about y.
std::shared_ptr<const Shape> read_corner_crack_block(TableReader& geometry);

}  // namespace cleave::geometry
