#include "benchmarks/engine_bench.hpp"
#include "benchmarks/rows.hpp"
#include "benchmarks/timing.hpp"
#include "solver/subdivision/plain_subdivision.hpp"

#ifdef CLEAVE_PEERS
#include "benchmarks/peers/vtk_clip.hpp"
#endif

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <memory>

namespace cleave::benchmarks {
namespace {

/// The engine, warm, in turns with pure stores of the same output.
void engine_beside_stores(benchmark::State& state, LazyCase& source) {
    EngineBench bench(source.get());
    PureStores stores = bench.stores();
    const auto store = [&] {
        stores.run();
        benchmark::ClobberMemory();
    };
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times([&] { bench.run(); }, store, passes_for(source.get().mesh), [&] { bench.engine.reset(); });
        state.SetIterationTime(times.first);
    }
    count_work(state, bench);
    state.counters["ratio_to_stores"] = times.ratio;
    state.counters["noise_to_stores"] = times.noise;
    state.counters["nanoseconds_per_child"] = 1e9 * times.first / bench.children();
    state.counters["stores_nanoseconds_per_child"] = 1e9 * times.second / bench.children();
}

/// The first cut of a new engine, whose memory was never written (cold), in turns with a later one (warm).
void engine_cold(benchmark::State& state, LazyCase& source) {
    EngineBench warm(source.get());
    std::unique_ptr<subdivision::SubdivisionEngine> cold;
    subdivision::Buffer<subdivision::ExtraLink> links;
    const auto first_cut = [&] {
        cold->cut(warm.cut);
        cold->find_extra_links(links);
    };
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times(first_cut, [&] { warm.run(); }, source.get().mesh.tets.size() < 20'000 ? 21 : 5, [&] {
            cold.reset();
            cold = std::make_unique<subdivision::SubdivisionEngine>(source.get().mesh);
            links = {};
            ::malloc_trim(0);  // the set-up's own temporary memory must not come back as written memory
            warm.engine.reset();
        });
        state.SetIterationTime(times.first);
    }
    count_work(state, warm);
    state.counters["ratio_to_warm"] = times.ratio;
    state.counters["noise_to_warm"] = times.noise;
    state.counters["nanoseconds_per_child"] = 1e9 * times.first / warm.children();
}

/// One thread in turns with two, on the wall.
void two_threads(benchmark::State& state, LazyCase& source) {
    EngineBench one(source.get()), two(source.get(), source.get().cut, 2);
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times([&] { one.run(); }, [&] { two.run(); }, 41, [&] {
            one.engine.reset();
            two.engine.reset();
        }, wall_seconds_of);
        state.SetIterationTime(times.second);
    }
    count_work(state, two);
    state.counters["speedup_over_one_thread"] = times.ratio;
    state.counters["noise_over_one_thread"] = times.noise;
}

/// The plain form (set-up, cut, links) in turns with the engine (set-up, cut, links).
void plain_beside_engine(benchmark::State& state, LazyCase& source) {
    const SubdivisionCase& body = source.get();
    EngineBench warm(body);
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times([&] { benchmark::DoNotOptimize(subdivision::subdivide(body.mesh, {body.cut})); },
                             [&] { benchmark::DoNotOptimize(EngineBench(body).extra_links.data()); }, 21);
        state.SetIterationTime(times.first);
    }
    count_work(state, warm);
    state.counters["speedup_over_plain_with_setup"] = times.ratio;
    state.counters["noise_over_plain_with_setup"] = times.noise;
}

/// The floor alone.
void pure_stores(benchmark::State& state, LazyCase& source, void (PureStores::*run)()) {
    const EngineBench bench(source.get());
    PureStores stores = bench.stores();
    for (auto _ : state) {
        (stores.*run)();
        benchmark::ClobberMemory();
    }
    count_work(state, bench);
    state.counters["bytes"] = static_cast<double>(stores.bytes());
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * stores.bytes()));
}

/// One disc of fixed size in a large body and in a small one, in turns: what a crack costs must not depend on the body.
void fixed_disc(benchmark::State& state, LazyCase& large, int cells, LazyCase& small, int small_cells) {
    EngineBench bench(large.get(), fixed_disc_in(cells)), other(small.get(), fixed_disc_in(small_cells));
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times([&] { bench.run(); }, [&] { other.run(); }, 401, [&] {
            bench.engine.reset();
            other.engine.reset();
        });
        state.SetIterationTime(times.first);
    }
    count_work(state, bench);
    state.counters["ratio_to_small_body_per_child"] = times.ratio * other.children() / bench.children();
    state.counters["noise_to_small_body_per_child"] = times.noise;
    state.counters["microseconds"] = 1e6 * times.first;
    state.counters["microseconds_in_small_body"] = 1e6 * times.second;
}

/// Sort, number, link: what a body costs once.
void set_up(benchmark::State& state, LazyCase& source) {
    const SubdivisionCase& body = source.get();
    std::vector<double> seconds;
    for (auto _ : state) {
        for (int pass = 0; pass < (body.mesh.tets.size() < 200'000 ? 7 : 3); ++pass) {
            seconds.push_back(seconds_of([&] { benchmark::DoNotOptimize(subdivision::SubdivisionEngine(body.mesh).counts()); }));
        }
        state.SetIterationTime(median(seconds));
    }
    state.counters["particles_before"] = static_cast<double>(body.mesh.tets.size());
    state.counters["nanoseconds_per_tet"] = 1e9 * median(seconds) / static_cast<double>(body.mesh.tets.size());
}

#ifdef CLEAVE_PEERS
/// VTK's clip of the same body by the same plane, both sides, in turns with the engine, both in memory that was written before. Warm: each
/// runs once more, untimed, right before it is timed; else each is timed after the other's pass.
void vtk_beside_engine(benchmark::State& state, LazyCase& source, bool warm) {
    EngineBench bench(source.get());
    VtkClip vtk(source.get().mesh);
    const int passes = source.get().mesh.tets.size() < 20'000 ? 101 : 21;
    const auto clip = [&] { vtk.clip(bench.cut); };
    const auto cut = [&] { bench.run(); };
    const auto reset = [&] { bench.engine.reset(); };
    PairedTimes times;
    for (auto _ : state) {
        times = warm ? warm_paired_times({clip}, {cut, reset}, passes) : paired_times(clip, cut, passes, reset);
        state.SetIterationTime(times.first);
    }
    count_work(state, bench);
    state.counters["vtk_cells"] = static_cast<double>(vtk.cells());
    state.counters["speedup_over_vtk"] = times.ratio;
    state.counters["noise_over_vtk"] = times.noise;
    state.counters["vtk_milliseconds"] = 1e3 * times.first;
    state.counters["milliseconds"] = 1e3 * times.second;
    state.counters["nanoseconds_per_child"] = 1e9 * times.second / bench.children();
}
void vtk_warm(benchmark::State& state, LazyCase& source) { vtk_beside_engine(state, source, true); }
void vtk_alternated(benchmark::State& state, LazyCase& source) { vtk_beside_engine(state, source, false); }

/// The same from the raw mesh, once: VTK's grid and clip, our set-up and cut.
void vtk_one_shot(benchmark::State& state, LazyCase& source) {
    const SubdivisionCase& body = source.get();
    EngineBench counted(body);
    PairedTimes times;
    for (auto _ : state) {
        times = paired_times([&] { VtkClip(body.mesh).clip(body.cut); },
                             [&] { benchmark::DoNotOptimize(EngineBench(body).extra_links.data()); }, body.mesh.tets.size() < 200'000 ? 21 : 3);
        state.SetIterationTime(times.first);
    }
    count_work(state, counted);
    state.counters["speedup_over_vtk_one_shot"] = times.ratio;
    state.counters["noise_over_vtk_one_shot"] = times.noise;
    state.counters["vtk_milliseconds"] = 1e3 * times.first;
    state.counters["milliseconds"] = 1e3 * times.second;
}
#endif

using Row = void (*)(benchmark::State&, LazyCase&);

void register_body(const std::string& name, const std::shared_ptr<LazyCase>& body) {
    const auto add = [&](const char* kind, Row row) {
        add_row("subdivision/" + std::string(kind) + "/" + name, [body, row](benchmark::State& state) { row(state, *body); });
    };
    add("engine", engine_beside_stores);
    add("setup", set_up);
    add("cold", engine_cold);
#ifdef CLEAVE_PEERS
    add("vtk", vtk_warm);
    add("vtk_alternated", vtk_alternated);
    add("vtk_one_shot", vtk_one_shot);
#endif
    const auto add_floor = [&](const char* kind, void (PureStores::*run)()) {
        const auto row = [body, run](benchmark::State& state) { pure_stores(state, *body, run); };
        benchmark::RegisterBenchmark(("subdivision/" + std::string(kind) + "/" + name).c_str(), row)->Unit(benchmark::kMicrosecond);
    };
    add_floor("stores", &PureStores::run);
    add_floor("stores_past_caches", &PureStores::run_past_caches);
}

/// A cube's rows, those of its fixed disc and of two threads among them.
void register_cube(const std::string& name, int cells, Bodies& bodies) {
    constexpr int small_cells = 10;
    const auto body = bodies.cube(cells), small = bodies.cube(small_cells);
    register_body(name, body);
    if (cells == small_cells) return;
    add_row("subdivision/disc/" + name, [=](benchmark::State& state) { fixed_disc(state, *body, cells, *small, small_cells); });
    add_row("subdivision/two_threads/" + name, [body](benchmark::State& state) { two_threads(state, *body); });
}

}  // namespace

void register_subdivision(Level level, Bodies& bodies) {
    const auto pot = bodies.pot();
    register_body("pot", pot);
    add_row("subdivision/plain/pot", [pot](benchmark::State& state) { plain_beside_engine(state, *pot); });
    register_cube("cube_6k", 10, bodies);
    register_cube("cube_83k", 24, bodies);
    if (level == Level::quick) return;
    register_cube("cube_945k", 54, bodies);
    register_cube("cube_4.7m", 92, bodies);
}

}  // namespace cleave::benchmarks
