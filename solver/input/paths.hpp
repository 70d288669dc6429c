#pragma once

#include <filesystem>

namespace cleave {

/// True where something stands at `path`; false also where the system cannot look (a name too long, no rights).
bool is_there(const std::filesystem::path& path);

/// The same for a file that is no folder.
bool is_file(const std::filesystem::path& path);

/// What a file calls `name`: from the current folder where it is there, else beside that file where it is there, else `name` as it is.
std::filesystem::path find_beside(const std::filesystem::path& name, const std::filesystem::path& file);

/// True for a path that, put behind a folder's, does not stay in it (absolute, empty, more ".." than folders); links are not followed.
bool leads_outside(const std::filesystem::path& path);

}  // namespace cleave
