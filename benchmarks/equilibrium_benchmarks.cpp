#include "benchmarks/engine_bench.hpp"
#include "benchmarks/rows.hpp"
#include "validation/adapters/level.hpp"
#include "validation/norms.hpp"
#include "validation/solutions.hpp"
#include "validation/suite.hpp"

#include <unistd.h>

#include <cmath>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>

namespace cleave::benchmarks {
namespace {

/// Seconds of the processor that all threads of this process take for some work.
template <class Work>
double processor_seconds(const Work& work) {
    const auto now = [] {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

/// The triclinic body under manufactured waves (validation/cases/equilibrium_manufactured.toml), its meshes in a folder of this process.
class Waves {
public:
    ~Waves() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    struct Answer {
        double seconds, error;
        long cells;
    };
    /// Reads the mesh, solves, gives stresses; the mesh was made before. `error`: rms of the stress over rms of the exact one.
    Answer answer(const std::string& solver, double size) {
        if (!case_) case_ = validation::read_cases((validation::case_folder() / "equilibrium_manufactured.toml").string(), {}).front();
        validation::LevelSources sources(*case_, size, folder_);
        Answer result{};
        result.seconds = processor_seconds([&] { sources.get(solver); });
        const validation::Samples& got = sources.get(solver).everywhere();
        const analytic::Field exact = validation::make_field(*case_->body_force_solution, *case_);
        result.error = validation::compare({"stress", ""}, got, validation::evaluate(exact, got.position), "rms").error;
        result.cells = sources.get(solver).resolution().particles;
        return result;
    }

private:
    std::optional<validation::Case> case_;  // read by the first row that runs
    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("cleave-bench-" + std::to_string(::getpid()));
};

/// A method on two meshes, and its time where log(time) against log(error) reaches the error asked for.
void time_to_accuracy(benchmark::State& state, Waves& waves, const std::string& solver, double coarse, double fine, double error) {
    Waves::Answer first{}, second{};
    double seconds = 0;
    for (auto _ : state) {
        first = waves.answer(solver, coarse);
        second = waves.answer(solver, fine);
        const double slope = std::log(second.seconds / first.seconds) / std::log(second.error / first.error);
        seconds = second.seconds * std::pow(error / second.error, slope);
        state.SetIterationTime(seconds);
    }
    state.counters["stress_error_asked"] = error;
    state.counters["seconds_at_that_error"] = seconds;
    state.counters["cells_coarse"] = static_cast<double>(first.cells);
    state.counters["cells_fine"] = static_cast<double>(second.cells);
    state.counters["seconds_coarse"] = first.seconds;
    state.counters["seconds_fine"] = second.seconds;
    state.counters["stress_error_coarse"] = first.error;
    state.counters["stress_error_fine"] = second.error;
}

struct Method {
    const char* name;
    const char* solver;
    double coarse, fine;  ///< sizes over the extent whose errors lie on either side of the one asked for
};

}  // namespace

void register_equilibrium(Level level) {
    const auto waves = std::make_shared<Waves>();
    const bool full = level == Level::full;
    const double error = full ? 0.05 : 0.1;
    const std::vector<Method> methods =
        full ? std::vector<Method>{{"conforming", "sph.conforming", 0.1, 0.07}, {"conforming_recovered", "sph.conforming_recovered", 0.17, 0.12},
                                   {"fem_p1", "fem.p1", 0.07, 0.042}, {"fem_p2", "fem.p2", 0.35, 0.25}}
             : std::vector<Method>{{"conforming", "sph.conforming", 0.2, 0.14}, {"conforming_recovered", "sph.conforming_recovered", 0.4, 0.25},
                                   {"fem_p1", "fem.p1", 0.12, 0.085}, {"fem_p2", "fem.p2", 0.7, 0.4}};
    for (const Method& method : methods)
        add_row(std::string("equilibrium/") + method.name,
                [=](benchmark::State& state) { time_to_accuracy(state, *waves, method.solver, method.coarse, method.fine, error); });
}

}  // namespace cleave::benchmarks
