#include "benchmarks/engine_bench.hpp"
#include "benchmarks/rows.hpp"
#include "benchmarks/timing.hpp"
#include "solver/elasticity/strain_pass.hpp"
#include "solver/material/material.hpp"
#include "solver/particles/neighbours.hpp"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleave::benchmarks {
namespace {

using particles::NeighbourLists;
using particles::Particles;

/// Neighbour lists by nanoflann's k-d tree, one radius search per particle.
class Nanoflann {
public:
    explicit Nanoflann(const Particles& particles) : particles_(particles) {}

    /// `by_id`: each list in the order of find_neighbours; as they come otherwise.
    const NeighbourLists& run(bool by_id) {
        const Tree tree(3, *this, nanoflann::KDTreeSingleIndexAdaptorParams(10));
        nanoflann::SearchParams unsorted;
        unsorted.sorted = false;
        lists_.offset.assign(1, 0);
        lists_.index.clear();
        for (int i = 0; i < particles_.size(); ++i) {
            const double h = particles_.support_radius[i];
            tree.radiusSearch(particles_.position[i].data(), h * h, hits_, unsorted);
            for (const auto& [j, distance] : hits_)
                if (j != i) lists_.index.push_back(j);
            if (by_id) std::sort(lists_.index.begin() + static_cast<std::ptrdiff_t>(lists_.offset.back()), lists_.index.end());
            lists_.offset.push_back(lists_.index.size());
        }
        return lists_;
    }

    // What the tree asks for.
    std::size_t kdtree_get_point_count() const { return particles_.position.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const { return particles_.position[i][static_cast<Eigen::Index>(axis)]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const { return false; }

private:
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Nanoflann>, Nanoflann, 3, int>;

    const Particles& particles_;
    NeighbourLists lists_;
    std::vector<std::pair<int, double>> hits_;
};

/// A body's particles with isotropic kernels, every support of the size its neighbours' spacing gives.
struct ParticleBody {
    explicit ParticleBody(LazyCase& source) : particles(particles::from_mesh(source.get().mesh)), lists(particles::find_neighbours(particles)) {}
    double pairs() const { return static_cast<double>(lists.index.size()); }

    Particles particles;
    NeighbourLists lists;
};

void count_work(benchmark::State& state, const ParticleBody& body) {
    state.counters["particles"] = body.particles.size();
    state.counters["pairs"] = body.pairs();
    state.counters["neighbours_per_particle"] = body.pairs() / body.particles.size();
}

/// find_neighbours in turns with nanoflann, both from the bare particles into lists whose memory is used again. Refuses to compare where the
/// lists differ.
void neighbours(benchmark::State& state, LazyCase& source, bool by_id) {
    const ParticleBody body(source);
    Nanoflann peer(body.particles);
    const NeighbourLists& expected = peer.run(true);
    if (expected.offset != body.lists.offset || expected.index != body.lists.index) throw std::logic_error("neighbours: nanoflann finds other lists");
    NeighbourLists ours;
    const auto find = [&] {
        particles::find_neighbours(body.particles, ours);
        benchmark::DoNotOptimize(ours.index.data());
    };
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times([&] { benchmark::DoNotOptimize(peer.run(by_id).index.data()); }, find,
                             passes_for(source.get().mesh));
        state.SetIterationTime(times.second);
    }
    count_work(state, body);
    state.counters["speedup_over_nanoflann"] = times.ratio;
    state.counters["noise_over_nanoflann"] = times.noise;
    state.counters["nanoseconds_per_particle"] = 1e9 * times.second / body.particles.size();
    state.counters["nanoflann_nanoseconds_per_particle"] = 1e9 * times.first / body.particles.size();
}

std::vector<Eigen::Vector3d> waves(const Particles& particles) {
    std::vector<Eigen::Vector3d> displacement;
    for (const Eigen::Vector3d& x : particles.position)
        displacement.emplace_back(std::sin(x[0] + 0.5 * x[1]), std::cos(x[1] - x[2]), std::sin(0.3 * x[0] * x[2]));
    return displacement;
}

/// Gradient, strain, stress and energy from positions and displacements: the pass in turns with the plain Eigen loop.
void gradient(benchmark::State& state, LazyCase& source) {
    const ParticleBody body(source);
    const elasticity::Solid solid = elasticity::uniform_solid(material::find_material("T300/5208").stiffness, body.particles.size());
    const std::vector<Eigen::Vector3d> displacement = waves(body.particles);
    elasticity::StrainPass pass(body.particles, body.lists, solid);
    elasticity::Fields fast, plain;
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times([&] { elasticity::plain_strain_pass(body.particles, body.lists, solid, displacement, plain); },
                             [&] { pass.evaluate(displacement, fast); }, passes_for(source.get().mesh) / 2);
        state.SetIterationTime(times.second);
    }
    const double energy = plain.total_energy();
    if (!(std::abs(fast.total_energy() - energy) < 1e-12 * energy)) throw std::logic_error("gradient: the pass and the Eigen loop differ");
    count_work(state, body);
    state.counters["speedup_over_eigen"] = times.ratio;
    state.counters["noise_over_eigen"] = times.noise;
    state.counters["nanoseconds_per_pair"] = 1e9 * times.second / body.pairs();
    state.counters["eigen_nanoseconds_per_pair"] = 1e9 * times.first / body.pairs();
}

}  // namespace

void register_particles(Level level, Bodies& bodies) {
    std::vector<std::pair<std::string, int>> cubes{{"cube_6k", 10}, {"cube_83k", 24}};
    if (level == Level::full) cubes.emplace_back("cube_945k", 54);
    for (const auto& [name, cells] : cubes) {
        const auto body = bodies.cube(cells);
        add_row("neighbours/" + name, [body](benchmark::State& state) { neighbours(state, *body, true); });
        add_row("neighbours/unsorted/" + name, [body](benchmark::State& state) { neighbours(state, *body, false); });
        add_row("gradient/" + name, [body](benchmark::State& state) { gradient(state, *body); });
    }
}

}  // namespace cleave::benchmarks
