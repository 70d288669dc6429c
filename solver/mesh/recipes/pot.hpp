#pragma once

#include "solver/mesh/recipes/occ_body.hpp"

#include <filesystem>

namespace cleave::mesh {

/// The paper's falling pot (Figs. 7 and 8; its sizes are not given, these are ours): a profile with a wall, revolved about the
/// z axis. Lengths in metres; the foot stands on z = 0.
struct PotShape {
    double height = 0.24;
    double foot_radius = 0.06;
    double belly_radius = 0.12;
    double neck_radius = 0.07;
    double rim_radius = 0.085;
    double wall = 0.014;
};

/// Leaves the profile as a plane face of the current Gmsh model (plane y = 0, x >= 0) and gives its tag: foot, outer wall, rim, inner wall, inner
/// floor, and the part of the axis inside the floor.
int add_pot_profile(const PotShape& shape);

OccBody pot_body(const PotShape& shape);

/// The pot as tets, to within 2 % of `target_count` (mesh_occ_body). Throws MeshingError.
Body pot(int target_count = 6163, const std::filesystem::path& cache = {}, const PotShape& shape = {}, Mesher mesher = Mesher::gmsh);

}  // namespace cleave::mesh
