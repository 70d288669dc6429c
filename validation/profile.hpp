#pragma once

#include "validation/adapters/level.hpp"
#include "validation/results.hpp"

namespace cleave::validation {

/// Writes one profile as CSV (`file` below `folder`): the first column is the abscissa, then one column per curve; the analytic
/// reference first, then each solver. Finite elements are read along the line; particles are shown where they lie, if nearer to
/// the line than `reach`, with the other columns empty in their rows. Rows are sorted by abscissa.
Artifact write_profile(const Profile& profile, const std::string& file, const std::filesystem::path& folder, LevelSources& sources);

}  // namespace cleave::validation
