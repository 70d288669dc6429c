#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>

namespace cleave::reports {

/// A JSON file. Throws InputError (file, line) where it is missing or broken.
nlohmann::json read_json(const std::filesystem::path& file);

/// The same for a file that may be missing (null then) and must hold an object.
nlohmann::json read_companion(const std::filesystem::path& file);

}  // namespace cleave::reports
