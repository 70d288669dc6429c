#include "benchmarks/subdivision_benchmarks.hpp"

#include "benchmarks/subdivision_work.hpp"
#include "benchmarks/timing.hpp"
#include "solver/subdivision/plain_subdivision.hpp"

#include <benchmark/benchmark.h>

#include <memory>
#include <stdexcept>

namespace cleave::benchmarks {
namespace {

using subdivision::Subdivided;

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
    explicit LazyCase(SubdivisionCase (*make)()) : make_(make) {}
    const SubdivisionCase& get() {
        if (!made_) made_ = std::make_unique<SubdivisionCase>(make_());
        return *made_;
    }

private:
    SubdivisionCase (*make_)();
    std::unique_ptr<SubdivisionCase> made_;
};

void count_work(benchmark::State& state, const SubdivisionCase& body, const Subdivided& result) {
    const int after = static_cast<int>(result.mesh.tets.size());
    if (after != result.counts.after()) throw std::logic_error("subdivision: particles after are not uncut + 14 n31 + 20 n22");
    state.counters["particles_before"] = static_cast<double>(body.mesh.tets.size());
    state.counters["particles_after"] = after;
    state.counters["uncut"] = result.counts.uncut;
    state.counters["n31"] = result.counts.three_one;
    state.counters["n22"] = result.counts.two_two;
    state.counters["extra_links"] = static_cast<double>(result.extra_links.size());
}

/// The paper's row: everything from the tets to children with links, on one thread.
void table2(benchmark::State& state, LazyCase& source, const PaperRow& paper) {
    const SubdivisionCase& body = source.get();
    Subdivided result;
    std::vector<double> seconds;
    for (auto _ : state) {
        seconds.push_back(seconds_of([&] { result = subdivision::subdivide(body.mesh, {body.cut}); }));
    }
    count_work(state, body, result);
    const double milliseconds = 1000 * median(seconds);
    state.counters["milliseconds"] = milliseconds;
    state.counters["milliseconds_per_added"] = milliseconds / static_cast<double>(result.mesh.tets.size() - body.mesh.tets.size());
    state.counters["paper_milliseconds"] = paper.milliseconds;
    state.counters["paper_milliseconds_per_added"] = paper.per_added();
    state.counters["paper_particles_after"] = paper.particles_after;
}

/// The plain form beside pure stores of the same output, in turns.
void plain_beside_stores(benchmark::State& state, LazyCase& source) {
    const SubdivisionCase& body = source.get();
    Subdivided result = subdivision::subdivide(body.mesh, {body.cut});
    PureStores stores = stores_like(result, body.mesh);
    std::vector<double> ratios, floor;
    for (auto _ : state) {
        const PairedTimes times = paired_times([&] { result = subdivision::subdivide(body.mesh, {body.cut}); },
                                               [&] { stores.run(); benchmark::ClobberMemory(); }, 5);
        state.SetIterationTime(times.first);
        ratios.push_back(times.ratio);
        floor.push_back(times.second);
    }
    count_work(state, body, result);
    state.counters["ratio_to_stores"] = median(ratios);
    state.counters["stores_milliseconds"] = 1000 * median(floor);
}

/// The floor alone.
void pure_stores(benchmark::State& state, LazyCase& source) {
    const SubdivisionCase& body = source.get();
    const Subdivided result = subdivision::subdivide(body.mesh, {body.cut});
    PureStores stores = stores_like(result, body.mesh);
    for (auto _ : state) {
        stores.run();
        benchmark::ClobberMemory();
    }
    count_work(state, body, result);
    state.counters["bytes"] = static_cast<double>(stores.bytes());
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * stores.bytes()));
}

}  // namespace

void register_subdivision(Level) {
    const auto pot = std::make_shared<LazyCase>(pot_case);
    benchmark::RegisterBenchmark("table2/pot", [pot](benchmark::State& state) { table2(state, *pot, paper_pot); })
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("subdivision/plain/pot", [pot](benchmark::State& state) { plain_beside_stores(state, *pot); })
        ->UseManualTime()->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("subdivision/stores/pot", [pot](benchmark::State& state) { pure_stores(state, *pot); })
        ->Unit(benchmark::kMicrosecond);
}

}  // namespace cleave::benchmarks
