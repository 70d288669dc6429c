#include "solver/input/file_io.hpp"

#include "solver/input/input_error.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <sstream>

namespace cleave {

std::string read_file(const std::filesystem::path& path) {
    std::error_code unknown;
    const std::filesystem::file_status status = std::filesystem::status(path, unknown);
    if (std::filesystem::is_directory(status)) throw InputError(path.string(), "", "a file (this is a folder)");
    if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status))
        throw InputError(path.string(), "", "a file (this is a device, which may have no end)");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw InputError(path.string(), "", "a readable file");
    std::ostringstream content;
    content << stream.rdbuf();
    if (stream.bad()) throw InputError(path.string(), "", "a readable file");
    return content.str();
}

void write_file_atomic(const std::filesystem::path& path, std::string_view content) {
    std::error_code ignored;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), ignored);
    std::filesystem::path part = path;
    part += fmt::format(".part{}", ::getpid());
    std::ofstream stream(part, std::ios::binary | std::ios::trunc);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.close();
    std::error_code failed;
    if (stream) std::filesystem::rename(part, path, failed);
    if (!stream || failed) {
        std::filesystem::remove(part, ignored);
        throw EnvironmentError(fmt::format("{}: cannot be written (rights, or disk full?)", path.string()));
    }
}

std::string content_hash(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
    return fmt::format("{:016x}", hash);
}

}  // namespace cleave
