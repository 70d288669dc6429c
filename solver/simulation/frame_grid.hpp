#pragma once

#include "solver/simulation/simulation.hpp"
#include "solver/simulation/vtu_file.hpp"

#include <string>
#include <vector>

namespace cleave::simulation {

/// The tets of all pieces of a simulation as VTU frames: cell data stress (Voigt, Pa), energy_density (J/m^3), fragment (its place among
/// the pieces), body, material (the region), parent (the original tet). What has not changed since the frame before is not compressed anew.
class FrameGrid {
public:
    std::string bytes(const Simulation& simulation);

private:
    void build(const Simulation& simulation);
    void append(const Simulation& simulation, int piece, std::vector<std::int32_t>& connectivity);

    int topology_ = -1, impacts_ = -1;
    VtuGrid grid_;
    std::vector<std::vector<Eigen::Vector3d>> rest_;  ///< per piece: its points
};

}  // namespace cleave::simulation
