#pragma once

#include "validation/geometry/shape.hpp"

/// Plates with a crack through their thickness: slabs a few elements thick, |z| <= thickness / 2, for plane strain (u_z = 0 on `bottom` and
/// `top`, the sides z low and z high of a box) and for fields that do not depend on z. Their meshes are those of cracked_box.hpp: elements
/// have size `size` at the front and grow by grading sqrt(size / a) (grading 1.6 unless given) per unit of distance from it, a the crack's (half) length.
namespace cleave::geometry {

ShapeInfo through_crack_block_info();
/// |x| <= half_width, |y| <= half_height, with a straight crack of half length crack_half_length about the z axis, along x turned by
/// crack_angle about z.
std::shared_ptr<const Shape> read_through_crack_block(TableReader& geometry);

ShapeInfo edge_crack_block_info();
/// 0 <= x <= width, |y| <= half_height, with a straight crack of length crack_length from the z axis on, along x turned by crack_angle
/// about z.
std::shared_ptr<const Shape> read_edge_crack_block(TableReader& geometry);

}  // namespace cleave::geometry
