#include "reports/json_file.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/paths.hpp"

#include <algorithm>

namespace cleave::reports {

using nlohmann::json;
using std::filesystem::path;

namespace {

int line_of(const std::string& text, std::size_t byte) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

}  // namespace

json read_json(const path& file) {
    const std::string text = read_file(file);
    try {
        return json::parse(text);
    } catch (const json::parse_error& error) {
        throw InputError(file.string(), line_of(text, error.byte), "", "valid JSON");
    } catch (const json::out_of_range&) {  // a number like 1e999, whose place it does not tell
        throw InputError(file.string(), "", "numbers of at most 1.8e308");
    }
}

json read_companion(const path& file) {
    if (!is_there(file)) return nullptr;
    json document = read_json(file);
    if (!document.is_object()) throw InputError(file.string(), "", "an object {...}");
    return document;
}

}  // namespace cleave::reports
