#include "validation/studies/stiffness_csv.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/material/stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

namespace cleave::validation {

namespace {

constexpr std::size_t constants = 21;
constexpr double gigapascal = 1e9;

using Cells = std::vector<std::string>;

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Semicolons where there are any, else tabs, else commas end the cells; a name in double quotes may hold one.
Cells cells_of(const std::string& line) {
    const char end = line.find(';') != std::string::npos ? ';' : line.find('\t') != std::string::npos ? '\t' : ',';
    Cells cells(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == end && !quoted)
            cells.emplace_back();
        else
            cells.back() += c;
    }
    for (std::string& cell : cells) cell = trimmed(cell);
    return cells;
}

std::optional<double> number_of(const std::string& cell) {
    double value = 0;
    const char* const last = cell.data() + cell.size();
    const auto [end, error] = std::from_chars(cell.data(), last, value);
    if (error != std::errc{} || end != last) return std::nullopt;
    return value;
}

bool is_title(const Cells& cells) {
    return std::none_of(cells.begin(), cells.end(), [](const std::string& cell) { return number_of(cell).has_value(); });
}

class Table {
public:
    explicit Table(std::string file) : file_(std::move(file)) {}

    std::vector<NamedStiffness> read() {
        std::string text = read_file(file_);
        if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);  // byte order mark of spreadsheets
        std::istringstream lines(text);
        bool first = true;
        for (std::string line; std::getline(lines, line);) {
            ++line_;
            if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
            const Cells cells = cells_of(line);
            if (!first || !is_title(cells)) add(cells);
            first = false;
        }
        if (tensors_.empty()) throw InputError(file_, "", fmt::format("lines of {} constants in GPa, C11, C12, ..., C66", constants));
        return std::move(tensors_);
    }

private:
    [[noreturn]] void fail(const std::string& expected) const { throw InputError(file_, line_, "", expected); }

    void add(const Cells& cells) {
        const std::size_t named = cells.size() > constants || !number_of(cells[0]) ? 1 : 0;
        if (cells.size() - named != constants)
            fail(fmt::format("{} numbers in GPa, C11, C12, ..., C16, C22, ..., C66, and perhaps a name before them (not {})", constants, cells.size() - named));
        const std::string name = named == 1 && !cells[0].empty() ? cells[0] : fmt::format("line {}", line_);
        if (!names_.insert(name).second) fail(fmt::format("a name of its own (not '{}' again)", name));
        std::array<double, constants> values{};
        for (std::size_t i = 0; i < constants; ++i) values[i] = gigapascal * constant(cells[i + named]);
        try {
            tensors_.push_back({name, material::from_upper_triangle(values)});
        } catch (const std::invalid_argument& error) {
            fail(fmt::format("{} ('{}')", error.what(), name));
        }
    }

    double constant(const std::string& cell) const {
        const std::optional<double> value = number_of(cell);
        if (!value || !std::isfinite(*value)) fail(fmt::format("a finite number in GPa (not '{}')", cell));
        return *value;
    }

    std::string file_;
    int line_ = 0;
    std::vector<NamedStiffness> tensors_;
    std::set<std::string> names_;
};

}  // namespace

std::vector<NamedStiffness> read_stiffness_csv(const std::filesystem::path& file) { return Table(file.string()).read(); }

}  // namespace cleave::validation
