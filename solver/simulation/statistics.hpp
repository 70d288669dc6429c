#pragma once

#include "solver/simulation/simulation.hpp"

#include <string>

namespace cleave::simulation {

/// A row of the paper's Tables 1 and 2; zero where the paper says nothing.
struct PaperRow {
    const char* scene;
    const char* row;                   ///< the paper's name
    int physical, subdivided, boundary, fragments;
    double analysis, subdivision, cracks, frame_rate;  ///< ms, ms, ms, 1/s
};

/// The paper's figures for a shipped scene, or null.
const PaperRow* paper_row(const std::string& scene);

/// Counts as they are now.
struct Counts {
    int physical = 0;            ///< particles at the start
    int subdivided = 0;          ///< particles now
    int boundary = 0;            ///< boundary particles of the bodies at the start
    int boundary_now = 0;        ///< of all pieces that collide
    int fragments = 0;           ///< pieces, debris among them; balls are none
    int debris = 0;
    double mass = 0, debris_mass = 0;  ///< kg
    double largest_share = 0;    ///< mass of the heaviest fragment over that of all
    double crack_area = 0;       ///< m^2 of crack faces, both sides, of all pieces
};
Counts count(const Simulation& simulation);

/// statistics.json, schema cleave.statistics/1: no timings, the same bytes for the same input.
std::string statistics_json(const Simulation& simulation);

/// How long a run took, of this process only.
struct RunTimes {
    double set_up = 0;     ///< s, meshes, kernels, operators
    double simulated = 0;  ///< s, frames without their output
    double processor = 0;  ///< s of processor time for the same frames, all threads together
    double output = 0;     ///< s
    int frames = 0;        ///< made by this process
    int threads = 0;
};
std::string timings_json(const Simulation& simulation, const RunTimes& times);

/// A few lines for people: the paper's columns beside ours.
std::string summary_text(const Simulation& simulation, const RunTimes& times);

}  // namespace cleave::simulation
