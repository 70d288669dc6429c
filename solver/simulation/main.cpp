// cleave-simulate: runs a scene and writes its frames, its animation and its figures.

#include "solver/input/command_line.hpp"
#include "solver/input/input_error.hpp"
#include "solver/simulation/run.hpp"
#include "solver/simulation/scene_table.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>

namespace cleave::simulation {
namespace {

volatile std::sig_atomic_t interrupted = 0;  // the one thing a signal may touch
constexpr int interrupted_exit_code = 130;   // as shells have it: 128 + SIGINT

struct Arguments {
    std::string scene, out, restart;
    std::vector<std::string> sets, table;
    int frames = 0, threads = 0;
    bool list = false, all_dynamic = false;
};

Overrides overrides_of(const Arguments& arguments) {
    Overrides overrides;
    for (const std::string& text : arguments.sets) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0) throw InputError("", "--set", fmt::format("KEY=VALUE (not '{}')", text));
        overrides.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
    if (arguments.all_dynamic) overrides.emplace_back("fracture.debris_below", "\"0 g\"");
    return overrides;
}

/// A bar with the remaining time on a terminal, a line every tenth of the way elsewhere; on stderr.
class Progress {
public:
    explicit Progress(int frames) : frames_(frames), terminal_(isatty(STDERR_FILENO) != 0) {}
    void step(const Simulation& simulation) {
        if (first_ < 0) first_ = simulation.frame() - 1;
        const int frame = simulation.frame(), done = frame - first_;
        const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        const double left = elapsed / done * (frames_ - frame);
        if (terminal_) {
            fmt::print(stderr, "\r\033[K[{:-<30}] {:.0f} s left  frame {}/{}, {} pieces", std::string(static_cast<std::size_t>(30 * frame / frames_), '#'), left,
                       frame, frames_, simulation.pieces().size());
            if (frame >= frames_) fmt::print(stderr, "\r\033[K");
        } else if (frame == frames_ || 10 * frame / frames_ != 10 * (frame - 1) / frames_) {
            fmt::print(stderr, "frame {}/{}, {} pieces, {:.0f} s left\n", frame, frames_, simulation.pieces().size(), left);
        }
    }

private:
    int frames_, first_ = -1;
    bool terminal_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

int run(const Arguments& arguments) {
    Overrides overrides = overrides_of(arguments);
    Scene scene = find_scene(arguments.scene, overrides);
    if (arguments.frames > 0) scene.frames = arguments.frames;
    const std::filesystem::path out = arguments.out.empty() ? "out/simulate" : arguments.out;
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });
    Progress progress(scene.frames);
    RunOptions options{.out = out, .meshes = std::filesystem::absolute(out).parent_path() / "meshes", .restart = arguments.restart, .threads = arguments.threads,
                       .stop = [] { return interrupted != 0; }, .frame_done = [&](const Simulation& simulation) { progress.step(simulation); }};
    const RunResult result = run_scene(scene, options);
    fmt::print("{}", result.summary);
    if (!result.interrupted) return 0;
    fmt::print(stderr, "\ncleave simulate: stopped after frame {}; {} holds what was done so far\n", result.frames, out.string());
    return interrupted_exit_code;
}

int body(int argc, char** argv) {
    CLI::App app("Runs a scene: rigid bodies that break.", "cleave simulate");
    Arguments arguments;
    app.add_option("scene", arguments.scene, "a shipped scene's name, or SCENE.toml");
    app.add_option("--out", arguments.out, "folder of the results; default: out/simulate");
    app.add_option("--frames", arguments.frames, "instead of the scene's")->check(CLI::PositiveNumber);
    app.add_option("--threads", arguments.threads, "default: all cores")->check(CLI::PositiveNumber);
    app.add_option("--restart", arguments.restart, "a checkpoint-*.cleave of an earlier run of this scene");
    app.add_option("--set", arguments.sets, "replace a value: KEY=VALUE with a dotted key, body[0].KEY for the first body")->allow_extra_args(false);
    app.add_flag("--all-dynamic", arguments.all_dynamic, "no debris: every fragment, however small, stays a rigid body");
    app.add_option("--table", arguments.table, "run nothing: the paper's Tables 1 and 2 beside the runs in these folders");
    app.add_flag("--list", arguments.list, "names of the shipped scenes");
    if (!parse_command_line(app, argc, argv, "cleave simulate", "valid options")) return 0;
    if (arguments.list) {
        fmt::print("{}\n", fmt::join(scene_names(), "\n"));
        return 0;
    }
    if (!arguments.table.empty()) {
        fmt::print("{}", scene_table({arguments.table.begin(), arguments.table.end()}));
        return 0;
    }
    if (arguments.scene.empty()) throw InputError("", "cleave simulate", fmt::format("SCENE.toml or one of {}", fmt::join(scene_names(), ", ")));
    return run(arguments);
}

}  // namespace
}  // namespace cleave::simulation

int main(int argc, char** argv) { return cleave::run_program("cleave simulate", cleave::simulation::body, argc, argv); }
