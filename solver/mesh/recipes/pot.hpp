#pragma once

#include "solver/mesh/recipes/body.hpp"

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

/// The pot as tets, region 1 "pot", surface 1 "outside" (the whole surface), meshed by Gmsh (Delaunay) to within 2 % of `target_count`.
/// `cache`: folder of stored meshes, empty for none. Throws MeshingError.
Body pot(int target_count = 6163, const std::filesystem::path& cache = {}, const PotShape& shape = {});

}  // namespace cleave::mesh
