#include "validation/expression.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <stdexcept>

namespace cleave::validation {

namespace {

/// Terms nest, and so do the calls that read and evaluate them.
constexpr std::size_t most_tokens = 1000;

/// Splits the text into names, numbers and operators.
std::vector<std::string> tokens_of(const std::string& text) {
    std::vector<std::string> tokens;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        std::size_t end = i + 1;
        if (std::isspace(static_cast<unsigned char>(c))) {
            i = end;
            continue;
        }
        if (std::isalpha(static_cast<unsigned char>(c))) {
            while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_')) ++end;
        } else if (std::isdigit(static_cast<unsigned char>(c)) || c == '.') {
            double ignored = 0;
            const auto result = std::from_chars(text.data() + i, text.data() + text.size(), ignored);
            end = static_cast<std::size_t>(result.ptr - text.data());
            if (end <= i || result.ec != std::errc()) throw std::invalid_argument(fmt::format("a number at '{}'", text.substr(i)));
        } else if ((c == '<' || c == '>') && end < text.size() && text[end] == '=') {
            ++end;
        } else if (std::string("<>*/-").find(c) == std::string::npos) {
            throw std::invalid_argument(fmt::format("a comparison like '1.2 < r/a < 3' (not '{}')", c));
        }
        if (tokens.size() == most_tokens) throw std::invalid_argument(fmt::format("at most {} words and numbers", most_tokens));
        tokens.push_back(text.substr(i, end - i));
        i = end;
    }
    return tokens;
}

class Parser {
public:
    Parser(const std::string& text, const Coordinates& coordinates) : tokens_(tokens_of(text)), coordinates_(coordinates) {}

    bool done() const { return at_ == tokens_.size(); }
    std::string peek() const { return done() ? "" : tokens_[at_]; }
    std::string next() {
        if (done()) throw std::invalid_argument("a number or a coordinate's name at the end of the expression");
        return tokens_[at_++];
    }

    std::function<double(const Point&)> term() {
        std::function<double(const Point&)> value = factor();
        while (peek() == "*" || peek() == "/") {
            const bool divide = next() == "/";
            value = [left = value, right = factor(), divide](const Point& p) { return divide ? left(p) / right(p) : left(p) * right(p); };
        }
        return value;
    }

private:
    std::function<double(const Point&)> factor() {
        const std::string token = next();
        if (token == "-") return [inner = factor()](const Point& p) { return -inner(p); };
        if (std::isdigit(static_cast<unsigned char>(token[0])) || token[0] == '.') {
            double number = 0;
            std::from_chars(token.data(), token.data() + token.size(), number);
            return [number](const Point&) { return number; };
        }
        const auto found = coordinates_.find(token);
        if (found != coordinates_.end()) return found->second;
        std::string known;
        for (const auto& [name, function] : coordinates_) known += (known.empty() ? "" : ", ") + name;
        throw std::invalid_argument(fmt::format("a number or one of {} (not '{}')", known, token));
    }

    std::vector<std::string> tokens_;
    const Coordinates& coordinates_;
    std::size_t at_ = 0;
};

bool is_relation(const std::string& token) { return token == "<" || token == ">" || token == "<=" || token == ">="; }

}  // namespace

Region::Region(const std::string& text, const Coordinates& coordinates) {
    Parser parser(text, coordinates);
    while (!parser.done()) {
        Term left = parser.term();
        if (!is_relation(parser.peek())) throw std::invalid_argument("a comparison like '1.2 < r/a < 3'");
        while (is_relation(parser.peek())) {
            const std::string relation = parser.next();
            Term right = parser.term();
            comparisons_.push_back({left, right, relation});
            left = right;
        }
        if (parser.done()) break;
        if (parser.next() != "and") throw std::invalid_argument("'and' between two comparisons");
        if (parser.done()) throw std::invalid_argument("a comparison after 'and'");
    }
}

bool Region::contains(const Point& point) const {
    for (const Comparison& comparison : comparisons_) {
        const double left = comparison.left(point), right = comparison.right(point);
        const bool holds = comparison.relation == "<"    ? left < right
                           : comparison.relation == "<=" ? left <= right
                           : comparison.relation == ">"  ? left > right
                                                         : left >= right;
        if (!holds) return false;
    }
    return true;
}

std::function<double(const Point&)> parse_term(const std::string& text, const Coordinates& coordinates) {
    Parser parser(text, coordinates);
    auto term = parser.term();
    if (!parser.done()) throw std::invalid_argument("one term like 'y/a'");
    return term;
}

}  // namespace cleave::validation
