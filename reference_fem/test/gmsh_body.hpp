#pragma once

#include <string>

namespace cleave::fem::testing {

/// Quarter of a plate with a hole of radius 1, half width 4, thickness 0.3, meshed by Gmsh from size 0.1 at the hole to 2 outside; one
/// unnamed physical volume, 1. Written as .msh 4.1 to the tests' temporary folder; returns the path.
std::string quarter_plate_with_hole(const std::string& name);

}  // namespace cleave::fem::testing
