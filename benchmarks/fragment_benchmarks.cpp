#include "benchmarks/engine_bench.hpp"
#include "benchmarks/rows.hpp"
#include "benchmarks/timing.hpp"
#include "solver/fragments/fragmented_body.hpp"

#include <numeric>

namespace cleave::benchmarks {
namespace {

/// The floor: reads four links of each tet once and writes a label.
class ReadLinks {
public:
    explicit ReadLinks(std::size_t tets) : links_(tets), labels_(tets) {
        for (std::size_t tet = 0; tet < tets; ++tet) links_[tet].fill(static_cast<int>(tet));
    }
    void run() {
        for (std::size_t tet = 0; tet < links_.size(); ++tet) labels_[tet] = std::accumulate(links_[tet].begin(), links_[tet].end(), 0);
        benchmark::ClobberMemory();
    }

private:
    std::vector<std::array<int, 4>> links_;
    std::vector<int> labels_;
};

/// Removing the links that a plane intersects and finding the fragments, the tets having been subdivided before.
void open_crack(benchmark::State& state, LazyCase& source, fragments::Scheme scheme) {
    const SubdivisionCase& source_body = source.get();
    const fragments::Crack crack{.disc = source_body.cut};
    fragments::FragmentedBody body(source_body.mesh, scheme);
    const auto prepare = [&] {
        body.reset();
        body.subdivide(crack, 0);
    };
    prepare();
    ReadLinks floor(body.fragment(0).particles.size());
    const auto particles = static_cast<double>(body.fragment(0).particles.size());
    fragments::CrackOutcome outcome;
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times([&] { outcome = body.open(crack, 0); }, [&] { floor.run(); }, 11, prepare);
        state.SetIterationTime(times.first);
    }
    state.counters["particles_before"] = body.originals();
    state.counters["particles_after"] = particles;
    state.counters["removed_links"] = outcome.removed_links;
    state.counters["fragments"] = static_cast<double>(body.current_fragments().size());
    state.counters["milliseconds"] = 1e3 * times.first;
    state.counters["nanoseconds_per_tet"] = 1e9 * times.first / body.originals();
    state.counters["nanoseconds_per_particle"] = 1e9 * times.first / particles;
    state.counters["ratio_to_reading_links"] = times.ratio;
    state.counters["noise_to_reading_links"] = times.noise;
}

}  // namespace

void register_fragments(Level, Bodies& bodies) {
    for (const auto& [name, cells] : {std::pair("cube_83k", 24), std::pair("cube_945k", 54)}) {
        const auto body = bodies.cube(cells);
        add_row(std::string("fragments/adaptive/") + name, [body](benchmark::State& state) { open_crack(state, *body, fragments::Scheme::adaptive); });
        add_row(std::string("fragments/basic/") + name, [body](benchmark::State& state) { open_crack(state, *body, fragments::Scheme::basic); });
    }
}

}  // namespace cleave::benchmarks
