#include "solver/input/paths.hpp"

#include <system_error>

namespace cleave {

bool is_there(const std::filesystem::path& path) {
    std::error_code unknown;
    return std::filesystem::exists(path, unknown);
}

bool is_file(const std::filesystem::path& path) {
    std::error_code unknown;
    return std::filesystem::is_regular_file(path, unknown);
}

std::filesystem::path find_beside(const std::filesystem::path& name, const std::filesystem::path& file) {
    const std::filesystem::path beside = file.parent_path() / name;  // an absolute name stays as it is
    return !is_there(name) && is_there(beside) ? beside : name;
}

bool leads_outside(const std::filesystem::path& path) {
    if (path.empty() || path.is_absolute()) return true;
    return path.lexically_normal().begin()->string() == "..";
}

}  // namespace cleave
