#include "reports/field_files.hpp"

#include "reports/artifact_table.hpp"
#include "solver/input/file_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace cleave::reports {

using nlohmann::json;
using std::filesystem::path;

namespace {

constexpr std::uintmax_t embedded_bytes = 16'000'000;

std::set<std::string> named_fields(const json& results) {
    std::set<std::string> files;
    for (const json& entry : results["cases"])
        for (const json& row : entry["checks"])
            for (const json& artifact : row.value("artifacts", json::array()))
                if (is_stress_field(artifact["file"])) files.insert(artifact["file"].get<std::string>());
    return files;
}

/// Letters of base64 for `count` numbers of 16 bits.
std::size_t letters_of(std::size_t count) { return (2 * count + 2) / 3 * 4; }

bool is_complete(const json& field) {
    if (!field.is_object() || field.value("schema", json()) != "cleave.stress_field/1" || !field.value("shown", json()).is_number_unsigned()) return false;
    if (!field.value("measures", json()).is_array() || field["measures"].empty()) return false;
    const auto shown = field["shown"].get<std::size_t>();
    constexpr std::array<std::pair<const char*, std::size_t>, 4> arrays{{{"position", 3}, {"radius", 1}, {"stress", 6}, {"difference", 6}}};
    return shown > 0 && std::all_of(arrays.begin(), arrays.end(), [&](const auto& array) {
        const json one = field.value(array.first, json());
        return one.is_object() && one.value("scale", json()).is_number() && one.value("data", json()).is_string() &&
               one["data"].template get_ref<const std::string&>().size() == letters_of(shown * array.second);
    });
}

json read_field(const path& file) {
    const json field = json::parse(read_file(file), nullptr, false);
    return is_complete(field) ? field : json{{"note", "not a stress field of schema cleave.stress_field/1"}};
}

}  // namespace

bool is_stress_field(const std::string& file) { return file.ends_with("stress_field.json"); }

json read_fields(const path& folder, const json& results, const std::string& results_file) {
    json fields = json::object();
    std::vector<std::pair<std::uintmax_t, std::string>> present;
    for (const std::string& file : named_fields(results)) {
        require_inside(file, results_file);
        if (std::filesystem::is_regular_file(folder / file))
            present.emplace_back(std::filesystem::file_size(folder / file), file);
        else
            fields[file] = {{"note", "the file is not in the results folder"}};
    }
    std::sort(present.begin(), present.end());
    std::uintmax_t total = 0;
    for (const auto& [size, file] : present) {
        const bool fits = total + size <= embedded_bytes;
        fields[file] = fits ? read_field(folder / file) : json{{"note", fmt::format("{:.1f} MB, too much for this page", 1e-6 * static_cast<double>(size))}};
        if (fits) total += size;
    }
    return fields;
}

}  // namespace cleave::reports
