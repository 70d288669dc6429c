#pragma once

#include "reference_fem/solution.hpp"
#include "solver/material/stiffness.hpp"
#include "validation/solve_note.hpp"

#include <filesystem>

namespace cleave::validation {

/// A free plate 0 <= z <= thickness, |x|, |y| <= half_width (m), hit on a circle of radius 1 m about the origin of its face z = 0 by
/// Hertz's pressure of 1 N along z. Tets of edge `size` round the circle, growing by `near_growth` times the distance from it up to 3 m from
/// its centre, by `growth` beyond.
struct ContactPlate {
    double half_width, thickness, size, near_growth, growth;
};

/// Its mesh: region 1, surface 1 the circle. Made once per plate.
std::filesystem::path contact_plate_mesh(const ContactPlate& plate, const std::filesystem::path& folder);

/// Quadratic finite elements on that mesh: nothing holds the plate, its inertia (uniform density) balances the load.
fem::Solution solve_contact_plate(const std::filesystem::path& mesh, const material::Stiffness& stiffness, SolveNote& note);

}  // namespace cleave::validation
