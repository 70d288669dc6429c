#include "solver/simulation/frame_grid.hpp"

#include <algorithm>

namespace cleave::simulation {
namespace {

constexpr std::uint8_t vtk_tetra = 10;

}  // namespace

/// Points shared within a piece stand once; pieces share none, since they move apart.
void FrameGrid::append(const Simulation& simulation, int number) {
    const Piece& piece = simulation.pieces()[number];
    const SceneBody& body = *simulation.bodies()[piece.body];
    rest_.emplace_back();
    if (body.is_ball()) return;
    const fragments::FragmentedBody& tets = body.fragmented();
    const std::vector<int>& particles = tets.fragment(piece.fragment).particles;
    std::vector<int> used;
    for (const int particle : particles)
        for (const int vertex : tets.vertices(particle)) used.push_back(vertex);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const int vertex : used) rest_.back().push_back(tets.point(vertex));
    const auto first = static_cast<std::int32_t>(grid_.points);
    for (const int particle : particles) {
        for (const int vertex : tets.vertices(particle))
            connectivity_.push_back(first + static_cast<std::int32_t>(std::lower_bound(used.begin(), used.end(), vertex) - used.begin()));
        const int parent = tets.parent(particle);
        const ParticleResult& result = body.results()[parent];
        stress_.insert(stress_.end(), result.stress.begin(), result.stress.end());
        energy_density_.push_back(result.energy_density);
        fragment_.push_back(number);
        body_.push_back(piece.body);
        material_.push_back(tets.region(particle));
        parent_.push_back(parent);
    }
    grid_.points += static_cast<std::int64_t>(used.size());
    grid_.cells += static_cast<std::int64_t>(particles.size());
}

void FrameGrid::build(const Simulation& simulation) {
    grid_ = {};
    rest_.clear();
    for (auto* list : {&connectivity_, &fragment_, &body_, &material_, &parent_}) list->clear();
    for (auto* list : {&stress_, &energy_density_}) list->clear();
    for (int piece = 0; piece < static_cast<int>(simulation.pieces().size()); ++piece) append(simulation, piece);
    std::vector<std::int32_t> offsets(static_cast<std::size_t>(grid_.cells));
    for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = 4 * (static_cast<std::int32_t>(i) + 1);
    grid_.connectivity = int_array("connectivity", connectivity_);
    grid_.offsets = int_array("offsets", offsets);
    grid_.types = byte_array("types", std::vector<std::uint8_t>(offsets.size(), vtk_tetra));
    grid_.cell_data = {float_array("stress", 6, stress_),     float_array("energy_density", 1, energy_density_), int_array("fragment", fragment_),
                       int_array("body", body_),              int_array("material", material_),                  int_array("parent", parent_)};
}

std::string FrameGrid::bytes(const Simulation& simulation) {
    const int impacts = static_cast<int>(simulation.state().impacts.size());  // each changes stresses
    if (topology_ != simulation.topology() || impacts_ != impacts) build(simulation);
    topology_ = simulation.topology();
    impacts_ = impacts;
    std::vector<float> positions;
    positions.reserve(3 * static_cast<std::size_t>(grid_.points));
    for (std::size_t i = 0; i < rest_.size(); ++i) {
        const rigid::Motion motion = simulation.motion(simulation.pieces()[i]);
        for (const Eigen::Vector3d& rest : rest_[i]) {
            const Eigen::Vector3d x = motion.at(rest);
            for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(x[k]));
        }
    }
    grid_.positions = float_array("positions", 3, positions);
    return vtu_bytes(grid_);
}

}  // namespace cleave::simulation
