#pragma once

#include "validation/geometry/shape.hpp"

namespace cleave::geometry {

ShapeInfo penny_crack_block_info();
/// A cube, |x|, |y|, |z| <= half_width, with a circular crack about its centre: the crack's normal is z turned by crack_angle about y.
/// The lips are doubled faces that share the surface `crack`; the vertices of the front are single. Elements have size `size` at the
/// front and grow by 0.8 sqrt(size / a) per unit of distance from it, a the crack's radius: halving `size` multiplies the tets by four.
std::shared_ptr<const Shape> read_penny_crack_block(TableReader& geometry);

}  // namespace cleave::geometry
