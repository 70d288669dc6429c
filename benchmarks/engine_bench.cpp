#include "benchmarks/engine_bench.hpp"

#include <stdexcept>

namespace cleave::benchmarks {

EngineBench::EngineBench(const SubdivisionCase& body, const subdivision::Cut& cut, int threads)
    : cut(cut), engine(body.mesh, {.tau = 0.1, .threads = threads}) {
    run();
}

void count_work(benchmark::State& state, const EngineBench& bench) {
    const subdivision::Counts& counts = bench.engine.counts();
    const std::size_t after = static_cast<std::size_t>(counts.uncut) + bench.engine.child_tets().size();
    if (static_cast<int>(after) != counts.after()) throw std::logic_error("subdivision: particles after are not uncut + 14 n31 + 20 n22");
    state.counters["particles_before"] = bench.engine.originals();
    state.counters["particles_after"] = static_cast<double>(after);
    state.counters["uncut"] = counts.uncut;
    state.counters["n31"] = counts.three_one;
    state.counters["n22"] = counts.two_two;
    state.counters["extra_links"] = static_cast<double>(bench.extra_links.size());
}

int passes_for(const mesh::TetMesh& mesh) { return mesh.tets.size() < 20'000 ? 201 : 21; }

void add_row(const std::string& name, std::function<void(benchmark::State&)> row) {
    benchmark::RegisterBenchmark(name.c_str(), [row = std::move(row)](benchmark::State& state) { row(state); })
        ->UseManualTime()->Iterations(1)->Unit(benchmark::kMicrosecond);
}

}  // namespace cleave::benchmarks
