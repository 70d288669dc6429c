#pragma once

#include "solver/simulation/simulation.hpp"
#include "solver/simulation/statistics.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace cleave::simulation {

struct RunOptions {
    std::filesystem::path out;
    std::filesystem::path meshes;    ///< folder of stored meshes; empty: none
    std::filesystem::path restart;   ///< a checkpoint; empty: from the start
    int threads = 0;                 ///< 0: all
    std::function<bool()> stop;      ///< asked before each substep; may be empty
    std::function<void(const Simulation&)> frame_done;  ///< after each frame; may be empty
};

struct RunResult {
    bool interrupted = false;
    int frames = 0;        ///< the last whole frame
    std::string summary;
};

/// Runs a scene and writes into `out`: frames.pvd and frames/NNNNN.vtu, surface.glb, statistics.json, timings.json, checkpoint-NNNNN.cleave (every
/// so many frames, and what a stop leaves). Files appear by renaming. A restart takes the VTU frames before the checkpoint from the
/// checkpoint's folder where that is another. The same bytes for any number of threads and across restarts, timings.json aside.
/// Throws InputError, EnvironmentError, mesh::MeshingError.
RunResult run_scene(const Scene& scene, const RunOptions& options);

}  // namespace cleave::simulation
