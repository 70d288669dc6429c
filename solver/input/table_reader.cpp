#include "solver/input/table_reader.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/paths.hpp"
#include "solver/input/toml_guard.hpp"

#include <fmt/format.h>

#define TOML_EXCEPTIONS 1
// A table's name that begins with no letter ("[;body]") fails an assertion of toml++ before it becomes the error that it is.
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

namespace cleave {

namespace detail {
/// One table inside a parsed file; children share the root, so that finish() sees the whole tree.
struct TomlDocument {
    std::shared_ptr<toml::table> root;
    toml::table* table = nullptr;
    std::string file;
    std::string path;  ///< dotted, "" for the root
    std::set<std::string> asked;
    std::vector<std::shared_ptr<TomlDocument>> children;
};
}  // namespace detail

namespace {

using detail::TomlDocument;

int line_of(const toml::node* node) { return node ? static_cast<int>(node->source().begin.line) : 0; }

std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row.back();
}

std::string nearest(const std::string& key, const std::set<std::string>& known) {
    std::string best;
    std::size_t distance = std::max<std::size_t>(2, key.size() / 3) + 1;
    for (const std::string& candidate : known)
        if (const std::size_t d = edit_distance(key, candidate); d < distance) {
            distance = d;
            best = candidate;
        }
    return best;
}

std::string list(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

const toml::node* find(TomlDocument& document, const std::string& key) {
    document.asked.insert(key);
    return document.table->get(key);
}

[[noreturn]] void fail_at(const TomlDocument& document, const toml::node* node, const std::string& dotted, const std::string& expected) {
    const int line = node ? line_of(node) : line_of(document.table);
    throw InputError(document.file, line, dotted, expected);
}

std::string dotted_key(const TomlDocument& document, const std::string& key) {
    return document.path.empty() ? key : document.path + "." + key;
}

/// Where a key is missing, a key that nobody asked for and that looks like it is its likely misspelling.
std::string missing_hint(const TomlDocument& document, const std::string& key) {
    for (auto&& [present, value] : *document.table) {
        const std::string name(present.str());
        if (!document.asked.contains(name) && !nearest(name, {key}).empty())
            return fmt::format(" (the key is missing; '{}' in line {} looks like it)", name, present.source().begin.line);
    }
    return " (the key is missing)";
}

const toml::node& require(TomlDocument& document, const std::string& key, const std::string& expected) {
    const toml::node* node = find(document, key);
    if (!node) fail_at(document, nullptr, dotted_key(document, key), expected + missing_hint(document, key));
    return *node;
}

double finite_number(TomlDocument& document, const toml::node& node, const std::string& dotted) {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) fail_at(document, &node, dotted, "a finite number");
    return *value;
}

Quantity quantity_of(TomlDocument& document, const toml::node& node, const std::string& dotted, const std::string& expected) {
    const auto text = node.value<std::string>();
    if (!text || !node.is_string()) {
        if (node.is_number()) return {finite_number(document, node, dotted), dimension::none, false};
        fail_at(document, &node, dotted, expected);
    }
    try {
        return parse_quantity(*text);
    } catch (const std::invalid_argument& error) {
        fail_at(document, &node, dotted, error.what());
    }
}

double checked_quantity(TomlDocument& document, const toml::node& node, const std::string& dotted, Dimension dimension) {
    const bool pure = dimension == dimension::none;
    const std::string expected = pure ? "a number" : fmt::format("a quantity with a unit like '1 {}'", unit_name(dimension));
    const Quantity quantity = quantity_of(document, node, dotted, expected);
    if (!(quantity.dimension == dimension) || quantity.angle)
        fail_at(document, &node, dotted, fmt::format("{} (not {})", expected, quantity.angle ? "an angle" : unit_name(quantity.dimension)));
    return quantity.value;
}

const toml::array& require_array(TomlDocument& document, const std::string& key, const std::string& expected) {
    const toml::node& node = require(document, key, expected);
    if (!node.is_array()) fail_at(document, &node, dotted_key(document, key), expected);
    return *node.as_array();
}

std::array<double, 3> vector_of(TomlDocument& document, const toml::node& node, const std::string& dotted, Dimension dimension) {
    const toml::array* array = node.as_array();
    if (!array || array->size() != 3) fail_at(document, &node, dotted, "an array of three quantities");
    std::array<double, 3> vector{};
    for (std::size_t i = 0; i < 3; ++i) vector[i] = checked_quantity(document, *array->get(i), dotted, dimension);
    return vector;
}

std::shared_ptr<TomlDocument> child(TomlDocument& document, const toml::node& node, const std::string& dotted) {
    if (!node.is_table()) fail_at(document, &node, dotted, "a table");
    auto made = std::make_shared<TomlDocument>();
    made->root = document.root;
    made->table = const_cast<toml::table*>(node.as_table());
    made->file = document.file;
    made->path = dotted;
    document.children.push_back(made);
    return made;
}

void reject_unknown(const TomlDocument& document) {
    const toml::node* first = nullptr;
    std::string name;
    for (auto&& [key, value] : *document.table) {
        if (document.asked.contains(std::string(key.str()))) continue;
        if (first && key.source().begin.line > static_cast<toml::source_index>(line_of(first))) continue;
        first = &value;
        name = std::string(key.str());
    }
    if (first) {
        const std::string hint = nearest(name, document.asked);
        const std::vector<std::string> known(document.asked.begin(), document.asked.end());
        fail_at(document, first, dotted_key(document, name),
                hint.empty() ? fmt::format("a known key ({})", list(known)) : fmt::format("a known key; did you mean '{}'?", hint));
    }
    for (const auto& made : document.children) reject_unknown(*made);
}

/// The value of "key", or of "key[2]" the third entry of an array; null where there is none.
toml::node* step_into(toml::table& table, const std::string& step) {
    const std::size_t bracket = step.find('[');
    if (bracket == std::string::npos || step.back() != ']') return table.get(step);
    toml::node* array = table.get(step.substr(0, bracket));
    const std::string digits = step.substr(bracket + 1, step.size() - bracket - 2);
    const bool number = !digits.empty() && digits.size() < 9 && digits.find_first_not_of("0123456789") == std::string::npos;
    return array && array->is_array() && number ? array->as_array()->get(std::stoul(digits)) : nullptr;
}

std::shared_ptr<TomlDocument> parse(const std::string& text, const std::string& name) {
    require_safe_toml(text, name);
    auto document = std::make_shared<TomlDocument>();
    try {
        document->root = std::make_shared<toml::table>(toml::parse(text, name));
    } catch (const toml::parse_error& error) {
        throw InputError(name, static_cast<int>(error.source().begin.line), "", fmt::format("valid TOML ({})", error.description()));
    }
    document->table = document->root.get();
    document->file = name;
    return document;
}

/// Its TOML text. Not toml++'s own text of arrays and tables: that breaks lines, by a width which overflows for numbers below 0.1.
std::string one_line(const toml::node& node) {
    std::vector<std::string> parts;
    if (const toml::array* array = node.as_array()) {
        for (const toml::node& part : *array) parts.push_back(one_line(part));
        return fmt::format("[{}]", fmt::join(parts, ", "));
    }
    if (const toml::table* table = node.as_table()) {
        for (const auto& [key, part] : *table) parts.push_back(fmt::format("{} = {}", key.str(), one_line(part)));
        return fmt::format("{{ {} }}", fmt::join(parts, ", "));
    }
    std::ostringstream text;
    node.visit([&](const auto& value) { text << value; });
    return text.str();
}

}  // namespace

TableReader::TableReader(std::shared_ptr<detail::TomlDocument> document) : document_(std::move(document)) {}

TableReader TableReader::from_file(const std::string& path) { return TableReader(parse(read_file(path), path)); }
TableReader TableReader::from_text(const std::string& text, const std::string& name) { return TableReader(parse(text, name)); }

bool TableReader::has(const std::string& key) const { return find(*document_, key) != nullptr; }

std::vector<std::string> TableReader::keys() const {
    std::vector<std::string> names;
    for (auto&& [key, value] : *document_->table) names.emplace_back(key.str());
    std::sort(names.begin(), names.end());
    return names;
}

std::string TableReader::string(const std::string& key) {
    const toml::node& node = require(*document_, key, "a string");
    if (!node.is_string()) fail_at(*document_, &node, dotted(key), "a string");
    return *node.value<std::string>();
}

double TableReader::number(const std::string& key) {
    return finite_number(*document_, require(*document_, key, "a finite number"), dotted(key));
}

long TableReader::integer(const std::string& key) {
    const toml::node& node = require(*document_, key, "an integer");
    if (!node.is_integer()) fail_at(*document_, &node, dotted(key), "an integer");
    return static_cast<long>(*node.value<std::int64_t>());
}

bool TableReader::boolean(const std::string& key) {
    const toml::node& node = require(*document_, key, "true or false");
    if (!node.is_boolean()) fail_at(*document_, &node, dotted(key), "true or false");
    return *node.value<bool>();
}

double TableReader::quantity(const std::string& key, Dimension dimension) {
    return checked_quantity(*document_, require(*document_, key, fmt::format("a quantity in {}", unit_name(dimension))), dotted(key), dimension);
}

double TableReader::angle(const std::string& key) {
    const toml::node& node = require(*document_, key, "an angle like '30 deg'");
    const Quantity quantity = quantity_of(*document_, node, dotted(key), "an angle like '30 deg'");
    if (!quantity.angle || !(quantity.dimension == dimension::none)) fail_at(*document_, &node, dotted(key), "an angle like '30 deg'");
    return quantity.value;
}

std::array<double, 3> TableReader::vector(const std::string& key, Dimension dimension) {
    return vector_of(*document_, require(*document_, key, "an array of three quantities"), dotted(key), dimension);
}

std::vector<std::array<double, 3>> TableReader::vectors(const std::string& key, Dimension dimension) {
    std::vector<std::array<double, 3>> result;
    for (const toml::node& node : require_array(*document_, key, "an array of points"))
        result.push_back(vector_of(*document_, node, dotted(key), dimension));
    return result;
}

std::vector<std::string> TableReader::strings(const std::string& key) {
    const toml::node& node = require(*document_, key, "a string or an array of strings");
    if (node.is_string()) return {*node.value<std::string>()};
    std::vector<std::string> result;
    for (const toml::node& entry : require_array(*document_, key, "a string or an array of strings")) {
        if (!entry.is_string()) fail_at(*document_, &entry, dotted(key), "a string or an array of strings");
        result.push_back(*entry.value<std::string>());
    }
    return result;
}

std::vector<double> TableReader::numbers(const std::string& key) {
    std::vector<double> result;
    for (const toml::node& node : require_array(*document_, key, "an array of numbers"))
        result.push_back(finite_number(*document_, node, dotted(key)));
    return result;
}

std::vector<std::vector<double>> TableReader::matrix(const std::string& key) {
    std::vector<std::vector<double>> rows;
    for (const toml::node& row : require_array(*document_, key, "an array of arrays of numbers")) {
        if (!row.is_array()) fail_at(*document_, &row, dotted(key), "an array of arrays of numbers");
        rows.emplace_back();
        for (const toml::node& entry : *row.as_array()) rows.back().push_back(finite_number(*document_, entry, dotted(key)));
    }
    return rows;
}

TableReader TableReader::table(const std::string& key) {
    return TableReader(child(*document_, require(*document_, key, "a table"), dotted(key)));
}

std::vector<TableReader> TableReader::tables(const std::string& key) {
    std::vector<TableReader> result;
    const toml::array& array = require_array(*document_, key, "an array of tables");
    for (std::size_t i = 0; i < array.size(); ++i)
        result.push_back(TableReader(child(*document_, *array.get(i), fmt::format("{}[{}]", dotted(key), i))));
    return result;
}

std::string TableReader::string_or(const std::string& key, const std::string& fallback) { return has(key) ? string(key) : fallback; }
double TableReader::number_or(const std::string& key, double fallback) { return has(key) ? number(key) : fallback; }
long TableReader::integer_or(const std::string& key, long fallback) { return has(key) ? integer(key) : fallback; }
bool TableReader::boolean_or(const std::string& key, bool fallback) { return has(key) ? boolean(key) : fallback; }
double TableReader::quantity_or(const std::string& key, Dimension dimension, double fallback) {
    return has(key) ? quantity(key, dimension) : fallback;
}
double TableReader::angle_or(const std::string& key, double fallback) { return has(key) ? angle(key) : fallback; }
std::optional<TableReader> TableReader::table_if(const std::string& key) {
    if (!has(key)) return std::nullopt;
    return table(key);
}
std::vector<TableReader> TableReader::tables_if(const std::string& key) { return has(key) ? tables(key) : std::vector<TableReader>{}; }

std::string TableReader::choice(const std::string& key, const std::vector<std::string>& allowed) {
    const std::string word = string(key);
    if (std::find(allowed.begin(), allowed.end(), word) == allowed.end())
        fail(key, fmt::format("one of {} (not '{}')", list(allowed), word));
    return word;
}

std::string TableReader::choice_or(const std::string& key, const std::vector<std::string>& allowed, const std::string& fallback) {
    return has(key) ? choice(key, allowed) : fallback;
}

std::filesystem::path TableReader::existing_file(const std::string& key) {
    std::filesystem::path path = find_beside(string(key), file());
    if (!is_there(path)) fail(key, fmt::format("an existing file (not '{}')", path.string()));
    return path;
}

std::string TableReader::raw(const std::string& key) {
    const toml::node& node = require(*document_, key, "a value");
    return one_line(node);
}

void TableReader::finish() const { reject_unknown(*document_); }

void TableReader::fail(const std::string& key, const std::string& expected) const {
    fail_at(*document_, document_->table->get(key), key.empty() ? document_->path : dotted(key), expected);
}

const std::string& TableReader::file() const { return document_->file; }
std::string TableReader::dotted(const std::string& key) const { return dotted_key(*document_, key); }

void TableReader::set(const std::string& dotted_key, const std::string& value_text) {
    toml::table* table = document_->table;
    std::string rest = dotted_key;
    for (std::size_t dot = rest.find('.'); dot != std::string::npos; dot = rest.find('.')) {
        toml::node* next = step_into(*table, rest.substr(0, dot));
        if (!next || !next->is_table()) throw InputError(document_->file, dotted_key, "a key inside an existing table");
        table = next->as_table();
        rest = rest.substr(dot + 1);
    }
    require_safe_toml(value_text, document_->file);
    try {
        toml::table parsed = toml::parse("value = " + value_text);
        parsed.get("value")->visit([&](auto&& value) { table->insert_or_assign(rest, value); });
    } catch (const toml::parse_error&) {
        table->insert_or_assign(rest, value_text);
    }
}

}  // namespace cleave
