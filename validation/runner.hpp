#pragma once

#include "validation/adapters/sources.hpp"
#include "validation/results.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace cleave::validation {

struct RunOptions {
    std::string level = "quick";
    std::filesystem::path out;
    std::function<void(const std::string&)> progress;  ///< called with one line per finished size; may be empty
};

struct CaseRun {
    CaseResult result;
    std::vector<SolveNote> solves;
};

/// Runs one case over its ladder: meshes each size, runs the solvers that its checks name, compares, judges. Artifacts are
/// written below options.out / case name. Throws InputError, EnvironmentError.
CaseRun run_case(const Case& of, const RunOptions& options);

/// fail if a row fails, pass if one passes and none fails, else info.
Verdict overall(const std::vector<Row>& rows);

/// A folder's name out of a case's name.
std::string artifact_folder(std::string case_name);

}  // namespace cleave::validation
