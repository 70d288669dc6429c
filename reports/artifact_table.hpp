#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace cleave::reports {

/// Most rows of one table that go into the page; longer tables are thinned evenly, first and last row kept.
inline constexpr std::size_t max_artifact_rows = 2000;

/// Throws InputError where an artifact's name leads outside its results folder (`results_file` names the culprit).
void require_inside(const std::string& file, const std::string& results_file);

/// A table of samples for the page: {"columns": [...], "rows": [[number or null, ...], ...], "total": rows in the file}, or
/// {"note": "why there is nothing to draw"} where the file is missing, no CSV, or malformed.
/// `file` is relative to `folder`; throws InputError where it leads outside the folder (`results_file` names the culprit).
nlohmann::json read_artifact(const std::filesystem::path& folder, const std::string& file, const std::string& results_file);

/// The same from the text of a CSV: first row names, then numbers; an empty cell or nan is null; lines with # are skipped.
nlohmann::json parse_artifact(const std::string& text);

}  // namespace cleave::reports
