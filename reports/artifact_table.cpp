#include "reports/artifact_table.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/paths.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

namespace cleave::reports {

using nlohmann::json;

namespace {

json note(const std::string& why) { return {{"note", why}}; }

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\"");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::size_t begin = 0;
    for (std::size_t end = 0; end != std::string::npos; begin = end + 1) {
        end = line.find(',', begin);
        cells.emplace_back(trimmed(std::string_view(line).substr(begin, end == std::string::npos ? end : end - begin)));
    }
    return cells;
}

/// A number, null for an empty cell or nan, nothing for anything else.
std::optional<json> parse_cell(const std::string& cell) {
    if (cell.empty()) return json(nullptr);
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
    return std::isfinite(value) ? json(value) : json(nullptr);
}

json thinned(std::vector<json> rows) {
    if (rows.size() <= max_artifact_rows) return json(std::move(rows));
    json kept = json::array();
    for (std::size_t i = 0; i < max_artifact_rows; ++i) {
        kept.push_back(std::move(rows[i * (rows.size() - 1) / (max_artifact_rows - 1)]));
    }
    return kept;
}

}  // namespace

json parse_artifact(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> columns;
    std::vector<json> rows;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        if (trimmed(line).empty() || line.front() == '#') continue;
        const std::vector<std::string> cells = split(line);
        if (columns.empty()) {
            columns = cells;
            continue;
        }
        if (cells.size() != columns.size()) return note(fmt::format("line {}: expected {} cells", number, columns.size()));
        json row = json::array();
        for (const std::string& cell : cells) {
            std::optional<json> value = parse_cell(cell);
            if (!value) return note(fmt::format("line {}: expected a number", number));
            row.push_back(std::move(*value));
        }
        rows.push_back(std::move(row));
    }
    if (columns.size() < 2) return note("expected a first row with two or more names");
    if (rows.empty()) return note("no rows");
    const std::size_t total = rows.size();
    return {{"columns", columns}, {"rows", thinned(std::move(rows))}, {"total", total}};
}

void require_inside(const std::string& file, const std::string& results_file) {
    if (leads_outside(file)) throw InputError(results_file, "artifacts: " + file, "a path inside the results folder");
}

json read_artifact(const std::filesystem::path& folder, const std::string& file, const std::string& results_file) {
    require_inside(file, results_file);
    const std::filesystem::path path = folder / file;
    if (path.extension() != ".csv") return note("not a table");
    if (!is_file(path)) return note("the file is not in the results folder");
    return parse_artifact(read_file(path));
}

}  // namespace cleave::reports
