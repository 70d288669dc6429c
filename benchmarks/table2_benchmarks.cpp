#include "benchmarks/engine_bench.hpp"
#include "benchmarks/rows.hpp"
#include "benchmarks/timing.hpp"
#include "solver/fragments/fragmented_body.hpp"

#include <cmath>

namespace cleave::benchmarks {
namespace {

/// One scenario of the paper's Tables 1 and 2 (Intel Xeon W3530 of 2010), milliseconds.
struct PaperRow {
    double stress_analysis, subdivision, crack_generation;
    double particles_before, particles_after;
    double per_added() const { return subdivision / (particles_after - particles_before); }
};
constexpr PaperRow paper_pot{86, 2869, 1505, 6163, 15'717};
constexpr PaperRow paper_pots{588, 12'923, 11'037, 80'119, 144'975};

/// The times of one pass over the cracks of a scenario, seconds.
struct StageTimes {
    std::vector<double> subdivision, crack_generation;
};

/// Opens the cracks one after another, each in the largest fragment there is.
void break_body(fragments::FragmentedBody& body, const std::vector<subdivision::Cut>& cuts, StageTimes& times) {
    double subdivision = 0, generation = 0;
    for (const subdivision::Cut& cut : cuts) {
        const std::vector<int> current = body.current_fragments();
        const int largest = *std::max_element(current.begin(), current.end(), [&](int a, int b) {
            return body.fragment(a).particles.size() < body.fragment(b).particles.size();
        });
        subdivision += seconds_of([&] { body.subdivide({.disc = cut}, largest); });
        generation += seconds_of([&] { body.open({.disc = cut}, largest); });
    }
    times.subdivision.push_back(subdivision);
    times.crack_generation.push_back(generation);
}

/// `count` equal bodies, each broken alike: what is measured is one, what is reported all.
void scenario(benchmark::State& state, LazyCase& source, int count, const PaperRow& paper) {
    const SubdivisionCase& body = source.get();
    std::unique_ptr<fragments::FragmentedBody> broken;
    const double setup = seconds_of([&] { broken = std::make_unique<fragments::FragmentedBody>(body.mesh); });
    StageTimes times;
    for (auto _ : state) {
        for (int pass = 0; pass <= passes_for(body.mesh); ++pass) {
            broken->reset();
            break_body(*broken, {body.cut}, times);
        }
        state.SetIterationTime(count * median(times.subdivision));
    }
    const subdivision::Counts& counts = broken->engine().counts();
    const double added = 13 * counts.three_one + 19 * counts.two_two;
    state.counters["particles_before"] = count * broken->originals();
    state.counters["particles_after"] = count * (broken->originals() + added);
    state.counters["uncut"] = count * counts.uncut;
    state.counters["n31"] = count * counts.three_one;
    state.counters["n22"] = count * counts.two_two;
    state.counters["fragments"] = count * static_cast<double>(broken->current_fragments().size());
    state.counters["milliseconds"] = 1e3 * count * median(times.subdivision);
    state.counters["milliseconds_per_added"] = 1e3 * median(times.subdivision) / added;
    state.counters["crack_generation_milliseconds"] = 1e3 * count * median(times.crack_generation);
    state.counters["setup_milliseconds"] = 1e3 * count * setup;
    state.counters["paper_milliseconds"] = paper.subdivision;
    state.counters["paper_milliseconds_per_added"] = paper.per_added();
    state.counters["paper_crack_generation_milliseconds"] = paper.crack_generation;
    state.counters["paper_stress_analysis_milliseconds"] = paper.stress_analysis;
    state.counters["paper_particles_after"] = paper.particles_after;
}

/// The exponent p of y ~ x^p by least squares of the logarithms.
double exponent(const std::vector<double>& x, const std::vector<double>& y) {
    const auto count = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0, covariance = 0, variance = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += std::log(x[i]) / count;
        mean_y += std::log(y[i]) / count;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        covariance += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
        variance += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
    }
    return covariance / variance;
}

/// How the two stages grow: subdivision with the particles added, crack generation with all particles.
void complexity(benchmark::State& state, const std::vector<std::shared_ptr<LazyCase>>& sources) {
    std::vector<double> added, all, subdivision, generation;
    for (auto _ : state) {
        for (const auto& source : sources) {
            fragments::FragmentedBody body(source->get().mesh);
            StageTimes times;
            for (int pass = 0; pass < 11; ++pass) {
                body.reset();
                break_body(body, {source->get().cut}, times);
            }
            all.push_back(body.originals());
            added.push_back(body.engine().counts().after() - body.originals());
            subdivision.push_back(median(times.subdivision));
            generation.push_back(median(times.crack_generation));
        }
        state.SetIterationTime(subdivision.back());
    }
    state.counters["work_bodies"] = static_cast<double>(sources.size());
    state.counters["work_largest_body"] = all.back();
    state.counters["exponent_of_subdivision_in_added"] = exponent(added, subdivision);
    state.counters["exponent_of_crack_generation_in_particles"] = exponent(all, generation);
}

}  // namespace

void register_table2(Level level, Bodies& bodies) {
    const auto pot = bodies.pot();
    add_row("table2/pot", [pot](benchmark::State& state) { scenario(state, *pot, 1, paper_pot); });
    add_row("table2/pots", [pot](benchmark::State& state) { scenario(state, *pot, 13, paper_pots); });
    std::vector<std::shared_ptr<LazyCase>> cubes{bodies.cube(10), bodies.cube(15), bodies.cube(24)};
    if (level == Level::full) cubes.push_back(bodies.cube(54));
    add_row("table2/complexity", [cubes](benchmark::State& state) { complexity(state, cubes); });
}

}  // namespace cleave::benchmarks
