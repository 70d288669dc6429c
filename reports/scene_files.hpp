#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>

namespace cleave::reports {

/// The scenes of a results folder: one object per folder FOLDER/scenes/NAME that holds a statistics.json (schema cleave.statistics/1), by name:
/// name, statistics, timings (null where missing), surface (surface.glb in base64, null where it is missing or left out), note (why it was
/// left out, else ""). Surfaces are embedded, smallest first, until the page would grow by more than 24 MB. Throws InputError: a companion
/// that is not JSON, another schema, a surface.glb that is none.
nlohmann::json read_scenes(const std::filesystem::path& folder);

}  // namespace cleave::reports
