#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cleave::simulation {

/// The columns of the paper's Tables 1 and 2 beside those of runs, one line for each folder that holds a statistics.json and a timings.json.
/// Run (a): all fragments dynamic; (b): debris as the scene says. Milliseconds are totals of a run, as the paper's seem to be.
/// Throws InputError: a file that is not there, or is none of ours.
std::string scene_table(const std::vector<std::filesystem::path>& folders);

}  // namespace cleave::simulation
