#include "solver/mesh/row_scanner.hpp"

#include "solver/input/input_error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace cleave::mesh {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";
/// Half faces are numbered 4 * tet + face in an int.
constexpr std::size_t index_limit = std::numeric_limits<int>::max() / 4;

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

template <class Number>
bool parse(std::string_view word, Number& value) {
    if (word.size() > 1 && word.front() == '+') word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

RowScanner::RowScanner(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

bool RowScanner::next_row() {
    while (position_ < text_.size()) {
        const std::size_t end = std::min(text_.find('\n', position_), text_.size());
        row_ = trimmed(text_.substr(position_, end - position_));
        rest_ = row_;
        position_ = end + 1;
        ++line_;
        if (!row_.empty()) return true;
    }
    return false;
}

void RowScanner::needed_row(const char* what) {
    if (!next_row()) fail(what, "more rows (the file ends here)");
}

void RowScanner::row(const char* what) {
    needed_row(what);
    if (row_.front() == '$') fail(what, "more rows (the section ends here)");
}

std::string_view RowScanner::word() {
    rest_ = trimmed(rest_);
    const std::size_t end = std::min(rest_.find_first_of(blanks), rest_.size());
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return found;
}

std::string_view RowScanner::rest() { return rest_ = trimmed(rest_); }

long RowScanner::integer(const char* what) {
    long value = 0;
    const std::string_view text = word();
    if (!parse(text, value)) fail(what, "an integer, not '" + std::string(text.substr(0, 40)) + "'");
    return value;
}

double RowScanner::real(const char* what) {
    double value = 0;
    const std::string_view text = word();
    if (!parse(text, value) || !std::isfinite(value)) fail(what, "a finite number, not '" + std::string(text.substr(0, 40)) + "'");
    return value;
}

std::size_t RowScanner::count(const char* what) {
    const long value = integer(what);
    const std::size_t left = text_.size() - std::min(position_, text_.size()) + rest_.size();
    if (value < 0) fail(what, "a count of at least 0, not " + std::to_string(value));
    const auto found = static_cast<std::size_t>(value);
    if (found > left || found > index_limit) fail(what, "a count that the file can hold, not " + std::to_string(value));
    return found;
}

void RowScanner::end_row(const char* what) {
    if (const std::string_view text = word(); !text.empty()) {
        fail(what, "the end of the row, not '" + std::string(text.substr(0, 40)) + "'");
    }
}

void RowScanner::fail(const std::string& key, const std::string& expected) const { throw InputError(name_, line_, key, expected); }

}  // namespace cleave::mesh
