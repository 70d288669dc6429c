#include "benchmarks/engine_bench.hpp"
#include "benchmarks/rows.hpp"
#include "benchmarks/scenarios.hpp"
#include "benchmarks/timing.hpp"
#include "solver/fragments/fragmented_body.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace cleave::benchmarks {
namespace {

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

/// The paper's three stages. Equal bodies: one is timed, all are reported.
void scenario(benchmark::State& state, const Scenario& scenario) {
    std::unique_ptr<ScenarioBody> body;
    const double setup = seconds_of([&] { body = std::make_unique<ScenarioBody>(scenario); });
    std::vector<double> analysis, subdivision, generation;
    for (auto _ : state) {
        for (int pass = 0; pass <= 21; ++pass) {
            const StageSeconds seconds = body->break_up();
            if (pass == 0) continue;
            analysis.push_back(seconds.stress_analysis);
            subdivision.push_back(seconds.subdivision);
            generation.push_back(seconds.crack_generation);
        }
        state.SetIterationTime(scenario.bodies * median(subdivision));
    }
    const fragments::FragmentedBody& broken = body->fragments();
    const subdivision::Counts& counts = broken.engine().counts();
    const double added = 13 * counts.three_one + 19 * counts.two_two, bodies = scenario.bodies;
    if (added == 0) throw std::logic_error("table2: the scenario's contacts made no crack");
    const PaperRow& paper = scenario.paper;
    state.counters["particles_before"] = bodies * broken.originals();
    state.counters["particles_after"] = bodies * (broken.originals() + added);
    state.counters["uncut"] = bodies * counts.uncut;
    state.counters["n31"] = bodies * counts.three_one;
    state.counters["n22"] = bodies * counts.two_two;
    state.counters["work_cracks"] = bodies * body->cracks();
    state.counters["fragments"] = bodies * static_cast<double>(broken.current_fragments().size());
    state.counters["stress_analysis_milliseconds"] = 1e3 * bodies * median(analysis);
    state.counters["milliseconds"] = 1e3 * bodies * median(subdivision);
    state.counters["milliseconds_per_added"] = 1e3 * median(subdivision) / added;
    state.counters["crack_generation_milliseconds"] = 1e3 * bodies * median(generation);
    state.counters["setup_milliseconds"] = 1e3 * bodies * setup;
    state.counters["paper_stress_analysis_milliseconds"] = paper.stress_analysis;
    state.counters["paper_milliseconds"] = paper.subdivision;
    state.counters["paper_milliseconds_per_added"] = paper.per_added();
    state.counters["paper_crack_generation_milliseconds"] = paper.crack_generation;
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
    for (const auto& [name, one] : scenarios()) {
        add_row("table2/" + name, [&one = one](benchmark::State& state) { scenario(state, one); });
    }
    std::vector<std::shared_ptr<LazyCase>> cubes{bodies.cube(10), bodies.cube(15), bodies.cube(24)};
    if (level == Level::full) cubes.push_back(bodies.cube(54));
    add_row("table2/complexity", [cubes](benchmark::State& state) { complexity(state, cubes); });
}

}  // namespace cleave::benchmarks
