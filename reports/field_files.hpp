#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace cleave::reports {

/// Whether an artifact is a stress field (schema cleave.stress_field/1), by its name.
bool is_stress_field(const std::string& file);

/// The stress fields that a results.json names: object, file -> the field as it was written, or {"note": "why there is nothing to draw"} where
/// the file is missing, of another schema, incomplete, or left out. Fields are embedded, smallest first, until the page would grow by more than
/// 16 MB. `results` has been checked by check_results. Throws InputError where a name leads outside the folder (`results_file` names the culprit).
nlohmann::json read_fields(const std::filesystem::path& folder, const nlohmann::json& results, const std::string& results_file);

}  // namespace cleave::reports
