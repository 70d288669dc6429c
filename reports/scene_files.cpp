#include "reports/scene_files.hpp"

#include "reports/json_file.hpp"
#include "solver/input/base64.hpp"
#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace cleave::reports {

using nlohmann::json;
using std::filesystem::path;

namespace {

constexpr std::uintmax_t embedded_bytes = 24'000'000;

std::vector<path> scene_folders(const path& folder) {
    std::vector<path> found;
    if (!std::filesystem::is_directory(folder)) return found;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (std::filesystem::exists(entry.path() / "statistics.json")) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

json read_statistics(const path& file) {
    json statistics = read_companion(file);
    if (statistics.value("schema", json()) != "cleave.statistics/1") throw InputError(file.string(), "schema", "\"cleave.statistics/1\"");
    return statistics;
}

std::string read_surface(const path& file) {
    const std::string bytes = read_file(file);
    if (bytes.substr(0, 4) != "glTF") throw InputError(file.string(), "", "a binary glTF file");
    return base64(bytes);
}

std::uintmax_t size_of(const path& file) { return std::filesystem::exists(file) ? std::filesystem::file_size(file) : 0; }

/// Small ones first, as long as they fit together.
void embed_surfaces(json& scenes, const std::vector<path>& folders) {
    std::vector<std::size_t> order(folders.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto size = [&](std::size_t i) { return size_of(folders[i] / "surface.glb"); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
    std::uintmax_t total = 0;
    for (const std::size_t i : order) {
        if (size(i) == 0) {
            scenes[i]["note"] = "no surface.glb";
        } else if (total + size(i) > embedded_bytes) {
            scenes[i]["note"] = fmt::format("surface.glb has {:.1f} MB, too much for this page: open it in Blender or another viewer",
                                            1e-6 * static_cast<double>(size(i)));
        } else {
            total += size(i);
            scenes[i]["surface"] = read_surface(folders[i] / "surface.glb");
        }
    }
}

}  // namespace

json read_scenes(const path& folder) {
    json scenes = json::array();
    const std::vector<path> folders = scene_folders(folder / "scenes");
    for (const path& scene : folders)
        scenes.push_back({{"name", scene.filename().string()}, {"statistics", read_statistics(scene / "statistics.json")},
                          {"timings", read_companion(scene / "timings.json")}, {"surface", nullptr}, {"note", ""}});
    embed_surfaces(scenes, folders);
    return scenes;
}

}  // namespace cleave::reports
