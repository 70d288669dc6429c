#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace cleave::reports {

/// Checks the shape of a results document (schema cleave.results/1) as far as the page relies on it: names, verdicts, numbers or
/// null, bands, ladders, artifacts, and that the counts are those of the rows. Unknown keys pass. Throws InputError that names
/// `file`, the key ("cases[0].checks[2].verdict") and what was expected.
void check_results(const nlohmann::json& results, const std::string& file);

}  // namespace cleave::reports
