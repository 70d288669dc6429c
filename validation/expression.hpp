#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace cleave::validation {

using Point = std::array<double, 3>;

/// Coordinates and lengths that a region may name: "x", "r", "a", ... Lengths ignore the position.
using Coordinates = std::map<std::string, std::function<double(const Point&)>>;

/// A condition on positions: comparisons of sums-free terms (products and quotients of numbers and named coordinates), chained
/// and joined by "and": "1.2 < r/a < 3 and z > 0.1*t". An empty text holds everywhere.
class Region {
public:
    /// Throws std::invalid_argument with what was expected (an unknown name lists the known ones).
    Region(const std::string& text, const Coordinates& coordinates);
    bool contains(const Point& point) const;

private:
    using Term = std::function<double(const Point&)>;
    struct Comparison {
        Term left, right;
        std::string relation;  // <, <=, >, >=
    };
    std::vector<Comparison> comparisons_;
};

/// One term, for axes of profiles: "y/a".
std::function<double(const Point&)> parse_term(const std::string& text, const Coordinates& coordinates);

}  // namespace cleave::validation
