#pragma once

#include "validation/geometry/shape.hpp"

namespace cleave::geometry {

/// A block below the plane z = 0, or its half (x >= 0) or quarter (x, y >= 0), with a circle about the origin marked on its top; it stands
/// for a half-space. Tets have the size asked for under the circle, size / rim_refinement at its rim, and grow with the distance from it.
struct ContactBlock {
    double contact_radius = 0;  ///< m, of the circle
    double half_width = 0;      ///< m; also the depth
    int sectors = 1;            ///< 1: whole, 2: half, 4: quarter
    double rim_refinement = 1;
};
/// Surfaces: contact (the circle), top (the rest), outer (sides and bottom), symmetry_x, symmetry_y (planes x = 0, y = 0). Region: body.
Body mesh_contact_block(const ContactBlock& block, double size, const std::filesystem::path& folder);

}  // namespace cleave::geometry
