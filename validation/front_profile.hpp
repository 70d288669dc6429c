#pragma once

#include "validation/adapters/level.hpp"
#include "validation/case.hpp"
#include "validation/results.hpp"

#include <filesystem>

namespace cleave::validation {

/// Along the crack's front by arc length (m), from the best finite elements that a case with checks of the front used: energy release rate by
/// domain integral and from the stress intensities, and the stress intensities, as two CSV files. Twelve places of a curved front, each a hat
/// of a tenth of the loop (crack_station.hpp); one of a straight front. None for other cases.
std::vector<Artifact> write_fronts(const Case& of, const LevelSources& sources, const std::string& case_folder, const std::filesystem::path& out);

}  // namespace cleave::validation
