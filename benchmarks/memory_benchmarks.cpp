#include "benchmarks/engine_bench.hpp"
#include "benchmarks/memory.hpp"
#include "benchmarks/rows.hpp"
#include "benchmarks/timing.hpp"
#include "solver/elasticity/strain_pass.hpp"
#include "solver/fragments/fragmented_body.hpp"
#include "solver/material/material.hpp"
#include "solver/particles/neighbours.hpp"

namespace cleave::benchmarks {
namespace {

/// What a piece of work leaves of its body: particles at its end.
using Work = std::size_t (*)(const SubdivisionCase&);

/// Set-up, cut and all links.
std::size_t subdivide(const SubdivisionCase& body) {
    const EngineBench bench(body);
    return static_cast<std::size_t>(bench.engine.counts().after());
}

/// The same with the fragments: links removed, pieces found.
std::size_t break_in_two(const SubdivisionCase& body) {
    fragments::FragmentedBody broken(body.mesh);
    broken.crack({.disc = body.cut}, 0);
    return static_cast<std::size_t>(broken.engine().counts().after());
}

/// Particles, their neighbours, one pass of gradient, strain, stress and energy.
std::size_t analyse(const SubdivisionCase& body) {
    const particles::Particles particles = particles::from_mesh(body.mesh);
    const particles::NeighbourLists lists = particles::find_neighbours(particles);
    const elasticity::Solid solid = elasticity::uniform_solid(material::find_material("T300/5208").stiffness, particles.size());
    elasticity::StrainPass pass(particles, lists, solid);
    elasticity::Fields fields;
    pass.evaluate(particles.position, fields);
    benchmark::DoNotOptimize(fields.total_energy());
    return static_cast<std::size_t>(particles.size());
}

void peak(benchmark::State& state, LazyCase& source, Work work) {
    const SubdivisionCase& body = source.get();
    std::size_t bytes = 0, after = 0;
    for (auto _ : state) state.SetIterationTime(wall_seconds_of([&] { bytes = peak_bytes_of([&] { after = work(body); }); }));
    const auto before = static_cast<double>(body.mesh.tets.size());
    state.counters["particles_before"] = before;
    state.counters["particles_after"] = static_cast<double>(after);
    state.counters["peak_megabytes"] = 1e-6 * static_cast<double>(bytes);
    state.counters["peak_bytes_per_particle_before"] = static_cast<double>(bytes) / before;
    state.counters["peak_bytes_per_particle_after"] = static_cast<double>(bytes) / static_cast<double>(after);
}

}  // namespace

void register_memory(Level level, Bodies& bodies) {
    std::vector<std::pair<std::string, int>> cubes{{"cube_83k", 24}};
    if (level == Level::full) cubes.insert(cubes.end(), {{"cube_945k", 54}, {"cube_4.7m", 92}});
    for (const auto& [name, cells] : cubes) {
        const auto body = bodies.cube(cells);
        const auto add = [&](const char* kind, Work work) {
            add_row("memory/" + std::string(kind) + "/" + name, [body, work](benchmark::State& state) { peak(state, *body, work); });
        };
        add("subdivision", subdivide);
        add("fragments", break_in_two);
        add("strain", analyse);
    }
}

}  // namespace cleave::benchmarks
