#pragma once

#include <array>
#include <string>
#include <vector>

namespace cleave::geometry {

/// left, right, front, back, bottom, top: the sides x, y, z low and high of a box, tags 1 to 6 in this order.
const std::vector<std::string>& box_side_names();

/// About how many tets of edge length `size` (m) fill a box: 6 sqrt(2) V / size^3, as if all were regular.
double tets_of_box(const std::array<double, 3>& extent, double size);

/// Tag of the side of the box from `low` to `high` (m) that a plane face of the current Gmsh model lies on, 0 for a face inside.
int box_side_of(int face, const std::array<double, 3>& low, const std::array<double, 3>& high);

}  // namespace cleave::geometry
