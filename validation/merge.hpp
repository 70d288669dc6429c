#pragma once

#include "validation/case_store.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace cleave::validation {

struct MergedRun {
    std::string level;
    std::vector<FinishedCase> cases;  ///< in the order of the run before it was split
};

/// Puts the folders of a run's shards together: the cases of each results.json, their artifacts copied into `out`. Throws InputError: a folder
/// without results.json or its finished cases, different levels, a case that two folders hold.
MergedRun merge_runs(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out);

}  // namespace cleave::validation
