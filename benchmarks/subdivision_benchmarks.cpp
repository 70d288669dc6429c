#include "benchmarks/subdivision_benchmarks.hpp"

#include "benchmarks/subdivision_work.hpp"
#include "benchmarks/timing.hpp"
#include "solver/subdivision/plain_subdivision.hpp"
#include "solver/subdivision/subdivision_engine.hpp"

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <stdexcept>

namespace cleave::benchmarks {
namespace {

/// Table 1 and Table 2 of the paper for one scenario, on an Intel Xeon W3530 of 2010.
struct PaperRow {
    double milliseconds;
    double particles_after;
    double added;
    double per_added() const { return milliseconds / added; }
};
constexpr PaperRow paper_pot{2869, 15717, 15717 - 6163};

/// Makes a case once, at its first use, and keeps it for all benchmarks that share it.
class LazyCase {
public:
    explicit LazyCase(std::function<SubdivisionCase()> make) : make_(std::move(make)) {}
    const SubdivisionCase& get() {
        if (!made_) made_ = std::make_unique<SubdivisionCase>(make_());
        return *made_;
    }

private:
    std::function<SubdivisionCase()> make_;
    std::unique_ptr<SubdivisionCase> made_;
};

/// An engine set up for a case, and its extra links.
struct Bench {
    explicit Bench(const SubdivisionCase& source) : body(source), engine(source.mesh) { run(); }
    void run() {
        engine.cut(body.cut);
        engine.find_extra_links(extra_links);
    }
    PureStores stores() const { return {static_cast<int>(engine.child_tets().size()), static_cast<int>(engine.points().size())}; }

    const SubdivisionCase& body;
    subdivision::SubdivisionEngine engine;
    std::vector<subdivision::ExtraLink> extra_links;
};

void count_work(benchmark::State& state, const Bench& bench) {
    const subdivision::Counts& counts = bench.engine.counts();
    const std::size_t after = static_cast<std::size_t>(counts.uncut) + bench.engine.child_tets().size();
    if (static_cast<int>(after) != counts.after()) throw std::logic_error("subdivision: particles after are not uncut + 14 n31 + 20 n22");
    state.counters["particles_before"] = static_cast<double>(bench.body.mesh.tets.size());
    state.counters["particles_after"] = static_cast<double>(after);
    state.counters["uncut"] = counts.uncut;
    state.counters["n31"] = counts.three_one;
    state.counters["n22"] = counts.two_two;
    state.counters["extra_links"] = static_cast<double>(bench.extra_links.size());
}

constexpr int most_passes = 201;
/// Rows of microseconds want more passes than rows of milliseconds.
int passes_for(const SubdivisionCase& body) { return body.mesh.tets.size() < 20'000 ? most_passes : 21; }

double children(const Bench& bench) { return static_cast<double>(bench.engine.child_tets().size()); }

// Each row that takes turns does its own passes, so Google Benchmark runs it once (Iterations(1)).

/// The paper's row: children with all links, one thread; the set-up, made once per body, stands beside it.
void table2(benchmark::State& state, LazyCase& source, const PaperRow& paper) {
    const SubdivisionCase& body = source.get();
    std::unique_ptr<Bench> bench;
    const double setup = seconds_of([&] { bench = std::make_unique<Bench>(body); });
    std::vector<double> seconds;
    for (auto _ : state) {
        for (int pass = 0; pass < passes_for(body); ++pass) {
            bench->engine.reset();
            seconds.push_back(seconds_of([&] { bench->run(); }));
        }
        state.SetIterationTime(median(seconds));
    }
    count_work(state, *bench);
    const double milliseconds = 1000 * median(seconds);
    const subdivision::Counts& counts = bench->engine.counts();
    state.counters["milliseconds"] = milliseconds;
    state.counters["milliseconds_per_added"] = milliseconds / (13 * counts.three_one + 19 * counts.two_two);
    state.counters["setup_milliseconds"] = 1000 * setup;
    state.counters["paper_milliseconds"] = paper.milliseconds;
    state.counters["paper_milliseconds_per_added"] = paper.per_added();
    state.counters["paper_particles_after"] = paper.particles_after;
}

/// The engine, warm, in turns with pure stores of the same output.
void engine_beside_stores(benchmark::State& state, LazyCase& source) {
    Bench bench(source.get());
    PureStores stores = bench.stores();
    const auto store = [&] {
        stores.run();
        benchmark::ClobberMemory();
    };
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times([&] { bench.run(); }, store, passes_for(bench.body), [&] { bench.engine.reset(); });
        state.SetIterationTime(times.first);
    }
    count_work(state, bench);
    state.counters["ratio_to_stores"] = times.ratio;
    state.counters["nanoseconds_per_child"] = 1e9 * times.first / children(bench);
    state.counters["stores_nanoseconds_per_child"] = 1e9 * times.second / children(bench);
}

/// The plain form (set-up, cut, links) in turns with the engine (set-up, cut, links).
void plain_beside_engine(benchmark::State& state, LazyCase& source) {
    const SubdivisionCase& body = source.get();
    Bench warm(body);
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times([&] { benchmark::DoNotOptimize(subdivision::subdivide(body.mesh, {body.cut})); },
                             [&] { benchmark::DoNotOptimize(Bench(body).extra_links.data()); }, 21);
        state.SetIterationTime(times.first);
    }
    count_work(state, warm);
    state.counters["ratio_to_engine_with_setup"] = times.ratio;
}

/// The floor alone.
void pure_stores(benchmark::State& state, LazyCase& source) {
    const Bench bench(source.get());
    PureStores stores = bench.stores();
    for (auto _ : state) {
        stores.run();
        benchmark::ClobberMemory();
    }
    count_work(state, bench);
    state.counters["bytes"] = static_cast<double>(stores.bytes());
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * stores.bytes()));
}

/// One disc of fixed size in a small body and in a large one, in turns: what a crack costs must not depend on the body.
void fixed_disc(benchmark::State& state, LazyCase& large, LazyCase& small) {
    Bench bench(large.get()), other(small.get());
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times([&] { bench.run(); }, [&] { other.run(); }, most_passes, [&] {
            bench.engine.reset();
            other.engine.reset();
        });
        state.SetIterationTime(times.first);
    }
    count_work(state, bench);
    state.counters["ratio_to_small_body_per_child"] = times.ratio * children(other) / children(bench);
}

/// Sort, number, link: what a body costs once.
void set_up(benchmark::State& state, LazyCase& source) {
    const SubdivisionCase& body = source.get();
    for (auto _ : state) benchmark::DoNotOptimize(subdivision::SubdivisionEngine(body.mesh).counts());
    state.counters["particles_before"] = static_cast<double>(body.mesh.tets.size());
    state.counters["nanoseconds_per_tet"] = benchmark::Counter(
        1e-9 * static_cast<double>(body.mesh.tets.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

using Row = void (*)(benchmark::State&, LazyCase&);

void add_row(const std::string& name, const std::shared_ptr<LazyCase>& body, Row row) {
    benchmark::RegisterBenchmark(name.c_str(), [body, row](benchmark::State& state) { row(state, *body); })
        ->UseManualTime()->Iterations(1)->Unit(benchmark::kMicrosecond);
}

void register_body(const std::string& name, const std::shared_ptr<LazyCase>& body) {
    add_row("subdivision/engine/" + name, body, engine_beside_stores);
    benchmark::RegisterBenchmark(("subdivision/stores/" + name).c_str(), [body](benchmark::State& state) { pure_stores(state, *body); })
        ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("subdivision/setup/" + name).c_str(), [body](benchmark::State& state) { set_up(state, *body); })
        ->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_subdivision(Level level) {
    const auto pot = std::make_shared<LazyCase>(pot_case);
    benchmark::RegisterBenchmark("table2/pot", [pot](benchmark::State& state) { table2(state, *pot, paper_pot); })
        ->UseManualTime()->Iterations(1)->Unit(benchmark::kMicrosecond);
    register_body("pot", pot);
    add_row("subdivision/plain/pot", pot, plain_beside_engine);
    const auto small_disc = std::make_shared<LazyCase>([] { return fixed_disc_case(10); });
    const auto add_disc = [&](const std::string& name, SubdivisionCase (*make)()) {
        const auto large = std::make_shared<LazyCase>(make);
        const auto row = [=](benchmark::State& state) { fixed_disc(state, *large, *small_disc); };
        benchmark::RegisterBenchmark(("subdivision/disc/" + name).c_str(), row)
            ->UseManualTime()->Iterations(1)->Unit(benchmark::kMicrosecond);
    };
    register_body("cube_6k", std::make_shared<LazyCase>([] { return cube_case(10); }));
    register_body("cube_83k", std::make_shared<LazyCase>([] { return cube_case(24); }));
    add_disc("cube_83k", [] { return fixed_disc_case(24); });
    if (level == Level::quick) return;
    register_body("cube_945k", std::make_shared<LazyCase>([] { return cube_case(54); }));
    add_disc("cube_945k", [] { return fixed_disc_case(54); });
}

}  // namespace cleave::benchmarks
