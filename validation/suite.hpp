#pragma once

#include "validation/case.hpp"
#include "validation/results.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace cleave::validation {

/// Where the shipped cases lie: the environment's CLEAVE_CASES, or the folder of the source tree.
std::filesystem::path case_folder();

/// Files of the shipped cases, sorted by name.
std::vector<std::filesystem::path> shipped_case_files();

/// The files behind names, globs ("fem_*") and paths; all shipped ones where `names` is empty. Throws InputError for a name
/// that matches nothing.
std::vector<std::filesystem::path> select_files(const std::vector<std::string>& names);

/// Every I-th of N, counted over the sorted cases: "2/3". Throws InputError.
std::vector<Case> shard(const std::vector<Case>& cases, const std::string& text);

/// What --list prints: cases, shapes, solutions, solvers, quantities.
std::string listing();

/// Compiler, versions, CPU, threads, commit: everything about a run that is not its result.
std::string provenance_json(const std::string& level);

}  // namespace cleave::validation
