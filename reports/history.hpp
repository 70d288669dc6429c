#pragma once

#include "reports/report_data.hpp"

#include <filesystem>
#include <vector>

namespace cleave::reports {

/// Earlier runs beside this one, oldest first: what each said in short, and what changed since the last of them.
///
///   runs     [ { folder, level, commit, counts, headline } ], the report itself last
///   changes  [ { kind: "drifted" | "new" | "vanished", case, what, before, now, verdict_before, verdict_now } ]
///
/// A row is the same where case, quantity, component, solver, place, reference and being a must-fail twin are. Throws InputError as
/// load_report does.
nlohmann::json read_history(const std::vector<std::filesystem::path>& folders, const Report& report);

}  // namespace cleave::reports
