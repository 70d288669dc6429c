#include "solver/simulation/run.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/parallel/on_threads.hpp"
#include "solver/simulation/frame_grid.hpp"
#include "solver/simulation/stopwatch.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/info.h>

#include <memory>

namespace cleave::simulation {
namespace {

namespace fs = std::filesystem;

std::string vtu_name(int frame) { return fmt::format("frames/{:05}.vtu", frame); }

/// Writes what a run leaves behind.
class Output {
public:
    Output(const Scene& scene, fs::path folder) : scene_(scene), folder_(std::move(folder)) {}

    /// A frame's tets, where it is one of those the scene asks for.
    void frame(const Simulation& simulation) {
        if (scene_.vtu_every == 0 || simulation.frame() % scene_.vtu_every != 0) return;
        write_file_atomic(folder_ / vtu_name(simulation.frame()), grid_.bytes(simulation));
    }

    void checkpoint(Simulation& simulation) const {
        write_file_atomic(folder_ / fmt::format("checkpoint-{:05}.cleave", simulation.frame()), checkpoint_bytes(simulation.save(), scene_.text));
    }

    /// The collection, the animation and the figures up to `last`.
    void finish(const Simulation& simulation, const RunTimes& times, int last) const {
        std::vector<PvdEntry> entries;
        for (int frame = 0; scene_.vtu_every > 0 && frame <= last; frame += scene_.vtu_every) entries.push_back({frame / scene_.frame_rate, vtu_name(frame)});
        write_file_atomic(folder_ / "frames.pvd", pvd_text(entries));
        write_file_atomic(folder_ / "surface.glb", glb_bytes(simulation.state().tracks, scene_.frame_rate, last));
        write_file_atomic(folder_ / "timings.json", timings_json(simulation, times));
        write_file_atomic(folder_ / "statistics.json", statistics_json(simulation));
    }

    /// The frames before a checkpoint, from the folder it lies in.
    void take_over_frames(const fs::path& checkpoint, int last) const {
        const fs::path from = fs::absolute(checkpoint).parent_path();
        if (scene_.vtu_every == 0 || fs::exists(folder_) ? fs::equivalent(from, folder_) : false) return;
        for (int frame = 0; frame <= last; frame += scene_.vtu_every) {
            if (!fs::exists(from / vtu_name(frame))) throw InputError((from / vtu_name(frame)).string(), "", "the frames of the run beside its checkpoint");
            write_file_atomic(folder_ / vtu_name(frame), read_file(from / vtu_name(frame)));
        }
    }

private:
    const Scene& scene_;
    fs::path folder_;
    FrameGrid grid_;
};

std::unique_ptr<Simulation> start(const Scene& scene, const RunOptions& options) {
    if (options.restart.empty()) return std::make_unique<Simulation>(scene, options.meshes);
    State state = read_checkpoint(read_file(options.restart), scene.text, options.restart.string());
    return std::make_unique<Simulation>(scene, options.meshes, std::move(state));
}

RunResult run_on_these_threads(const Scene& scene, const RunOptions& options, RunTimes times) {
    std::unique_ptr<Simulation> simulation;
    {
        const Stopwatch watch(times.set_up);
        simulation = start(scene, options);
    }
    Output output(scene, options.out);
    if (options.restart.empty()) {
        const Stopwatch watch(times.output);
        output.frame(*simulation);
    } else {
        output.take_over_frames(options.restart, simulation->frame());
    }
    RunResult result;
    while (simulation->frame() < scene.frames && !result.interrupted) {
        {
            const Stopwatch watch(times.simulated);
            const ProcessorWatch processor(times.processor);
            result.interrupted = !simulation->advance(options.stop);
        }
        if (result.interrupted) break;
        ++times.frames;
        const Stopwatch watch(times.output);
        output.frame(*simulation);
        if (scene.checkpoint_every > 0 && simulation->frame() % scene.checkpoint_every == 0) output.checkpoint(*simulation);
        if (options.frame_done) options.frame_done(*simulation);
    }
    result.frames = simulation->frame() - (result.interrupted ? 1 : 0);
    output.finish(*simulation, times, result.frames);
    result.summary = summary_text(*simulation, times);
    return result;
}

}  // namespace

RunResult run_scene(const Scene& scene, const RunOptions& options) {
    const RunTimes times{.threads = options.threads > 0 ? options.threads : oneapi::tbb::info::default_concurrency()};
    return parallel::on_threads(times.threads, [&] { return run_on_these_threads(scene, options, times); });
}

}  // namespace cleave::simulation
