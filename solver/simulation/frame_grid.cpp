#include "solver/simulation/frame_grid.hpp"

#include <algorithm>

namespace cleave::simulation {
namespace {

constexpr std::uint8_t vtk_tetra = 10;

/// A tet of a piece.
struct Cell {
    int piece;
    int body;
    const fragments::FragmentedBody* tets;
    const std::vector<ParticleResult>* results;
    int particle;

    const ParticleResult& result() const { return (*results)[tets->parent(particle)]; }
};

/// Calls each(Cell) for the tets of all pieces, in the order of the file.
template <class Each>
void for_cells(const Simulation& simulation, const Each& each) {
    for (int number = 0; number < static_cast<int>(simulation.pieces().size()); ++number) {
        const Piece& piece = simulation.pieces()[number];
        const SceneBody& body = *simulation.bodies()[piece.body];
        if (body.is_ball()) continue;
        for (const int particle : body.fragmented().fragment(piece.fragment).particles)
            each(Cell{number, piece.body, &body.fragmented(), &body.results(), particle});
    }
}

std::int64_t cells_of(const Simulation& simulation) {
    std::int64_t count = 0;
    for_cells(simulation, [&](const Cell&) { ++count; });
    return count;
}

VtuArray stress_of(const Simulation& simulation, std::size_t cells) {
    std::vector<float> values;
    values.reserve(6 * cells);
    for_cells(simulation, [&](const Cell& cell) { values.insert(values.end(), cell.result().stress.begin(), cell.result().stress.end()); });
    return compressed(float_array("stress", 6, values));
}

VtuArray energy_density_of(const Simulation& simulation, std::size_t cells) {
    std::vector<float> values;
    values.reserve(cells);
    for_cells(simulation, [&](const Cell& cell) { values.push_back(cell.result().energy_density); });
    return compressed(float_array("energy_density", 1, values));
}

}  // namespace

/// Points shared within a piece stand once; pieces share none, since they move apart.
void FrameGrid::append(const Simulation& simulation, int number, std::vector<std::int32_t>& connectivity) {
    const Piece& piece = simulation.pieces()[number];
    const SceneBody& body = *simulation.bodies()[piece.body];
    rest_.emplace_back();
    if (body.is_ball()) return;
    const fragments::FragmentedBody& tets = body.fragmented();
    const std::vector<int>& particles = tets.fragment(piece.fragment).particles;
    std::vector<int> used;
    used.reserve(4 * particles.size());
    for (const int particle : particles)
        for (const int vertex : tets.vertices(particle)) used.push_back(vertex);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    rest_.back().reserve(used.size());
    for (const int vertex : used) rest_.back().push_back(tets.point(vertex));
    const auto first = static_cast<std::int32_t>(grid_.points);
    for (const int particle : particles)
        for (const int vertex : tets.vertices(particle))
            connectivity.push_back(first + static_cast<std::int32_t>(std::lower_bound(used.begin(), used.end(), vertex) - used.begin()));
    grid_.points += static_cast<std::int64_t>(used.size());
}

/// One array after the other, so that a large body's frame needs little more memory than the file.
void FrameGrid::build(const Simulation& simulation) {
    grid_ = {};
    rest_.clear();
    grid_.cells = cells_of(simulation);
    const auto cells = static_cast<std::size_t>(grid_.cells);
    {
        std::vector<std::int32_t> connectivity;
        connectivity.reserve(4 * cells);
        for (int piece = 0; piece < static_cast<int>(simulation.pieces().size()); ++piece) append(simulation, piece, connectivity);
        grid_.connectivity = compressed(int_array("connectivity", connectivity));
    }
    {
        std::vector<std::int32_t> offsets(cells);
        for (std::size_t i = 0; i < cells; ++i) offsets[i] = 4 * (static_cast<std::int32_t>(i) + 1);
        grid_.offsets = compressed(int_array("offsets", offsets));
    }
    grid_.types = compressed(byte_array("types", std::vector<std::uint8_t>(cells, vtk_tetra)));
    const auto ints = [&](const char* name, const auto& value) {
        std::vector<std::int32_t> values;
        values.reserve(cells);
        for_cells(simulation, [&](const Cell& cell) { values.push_back(value(cell)); });
        return compressed(int_array(name, values));
    };
    grid_.cell_data = {stress_of(simulation, cells), energy_density_of(simulation, cells)};
    grid_.cell_data.push_back(ints("fragment", [](const Cell& cell) { return cell.piece; }));
    grid_.cell_data.push_back(ints("body", [](const Cell& cell) { return cell.body; }));
    grid_.cell_data.push_back(ints("material", [](const Cell& cell) { return cell.tets->region(cell.particle); }));
    grid_.cell_data.push_back(ints("parent", [](const Cell& cell) { return cell.tets->parent(cell.particle); }));
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
