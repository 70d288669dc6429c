#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cleave {

/// The whole file. Throws InputError where it is missing, a folder, or unreadable.
std::string read_file(const std::filesystem::path& path);

/// Writes beside `path` and renames, so that a reader never sees half a file. Makes missing parent folders.
/// Throws EnvironmentError (disk full, no rights); nothing is left behind then.
void write_file_atomic(const std::filesystem::path& path, std::string_view content);

/// 64-bit FNV-1a of the bytes, 16 hex digits: names cached files and fingerprints inputs (not cryptographic).
std::string content_hash(std::string_view bytes);

}  // namespace cleave
