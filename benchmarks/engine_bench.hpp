#pragma once

#include "benchmarks/subdivision_work.hpp"
#include "solver/subdivision/subdivision_engine.hpp"

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

namespace cleave::benchmarks {

/// An engine set up for a body, cut once, and its extra links.
struct EngineBench {
    EngineBench(const SubdivisionCase& body, const subdivision::Cut& cut, int threads = 1);
    explicit EngineBench(const SubdivisionCase& body) : EngineBench(body, body.cut) {}
    void run() {
        engine.cut(cut);
        engine.find_extra_links(extra_links);
    }
    double children() const { return static_cast<double>(engine.child_tets().size()); }
    PureStores stores() const { return {static_cast<int>(engine.child_tets().size()), static_cast<int>(engine.points().size())}; }

    subdivision::Cut cut;
    subdivision::SubdivisionEngine engine;
    subdivision::Buffer<subdivision::ExtraLink> extra_links;
};

/// particles_before, particles_after, uncut, n31, n22, extra_links; checks that particles_after = uncut + 14 n31 + 20 n22.
void count_work(benchmark::State& state, const EngineBench& bench);

/// Rows of microseconds want more passes than rows of milliseconds.
int passes_for(const mesh::TetMesh& mesh);

/// A row that takes turns and times itself: Google Benchmark runs it once.
void add_row(const std::string& name, std::function<void(benchmark::State&)> row);

}  // namespace cleave::benchmarks
