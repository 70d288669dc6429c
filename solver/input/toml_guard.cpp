#include "solver/input/toml_guard.hpp"

#include "solver/input/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace cleave {

namespace {

/// Where the string that begins at `at` with a quote ends: behind its closing quote, or at the end of the text.
std::size_t end_of_string(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const std::string triple(3, quote);
    const std::string_view mark = text.substr(at).starts_with(triple) ? std::string_view(triple) : text.substr(at, 1);
    at += mark.size();
    while (at < text.size() && !text.substr(at).starts_with(mark)) {
        if (mark.size() == 1 && text[at] == '\n') return at;  // not closed: toml++ says so
        at += quote == '"' && text[at] == '\\' ? 2 : 1;
    }
    at = std::min(at + mark.size(), text.size());
    for (int own = 0; own < 2 && mark.size() == 3 && text.substr(at).starts_with(quote); ++own) ++at;  // five quotes: two are the string's own
    return at;
}

[[noreturn]] void fail_at(std::string_view text, std::size_t at, const std::string& name, const std::string& expected) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    throw InputError(name, static_cast<int>(line), "", expected);
}

bool in_key(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view("._- \t").find(c) != std::string_view::npos; }

}  // namespace

void require_safe_toml(std::string_view text, const std::string& name) {
    constexpr int most_parts = 100;
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    int parts = 1;
    for (std::size_t at = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0; at < text.size();) {
        const char c = text[at];
        if (c == '"' || c == '\'') {
            at = end_of_string(text, at);
            continue;
        }
        if (static_cast<unsigned char>(c) >= 0x80) fail_at(text, at, name, "valid TOML (letters beyond ASCII in strings and comments only)");
        if (c == '#') at = std::min(text.find('\n', at), text.size());
        if (c == '.') ++parts;
        else if (!in_key(c)) parts = 1;
        if (parts > most_parts) fail_at(text, at, name, fmt::format("keys of at most {} parts", most_parts));
        ++at;
    }
}

}  // namespace cleave
