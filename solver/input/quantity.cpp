#include "solver/input/quantity.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave {

namespace {

struct Unit {
    std::string_view name;
    double scale;
    Dimension dimension;
    bool angle = false;
};

using namespace dimension;
constexpr std::array units{
    Unit{"m", 1, length}, Unit{"km", 1e3, length}, Unit{"cm", 1e-2, length}, Unit{"mm", 1e-3, length},
    Unit{"um", 1e-6, length}, Unit{"nm", 1e-9, length}, Unit{"in", 0.0254, length},
    Unit{"kg", 1, mass}, Unit{"g", 1e-3, mass}, Unit{"mg", 1e-6, mass}, Unit{"t", 1e3, mass},
    Unit{"s", 1, time}, Unit{"ms", 1e-3, time}, Unit{"us", 1e-6, time}, Unit{"Hz", 1, frequency},
    Unit{"N", 1, force}, Unit{"mN", 1e-3, force}, Unit{"kN", 1e3, force}, Unit{"MN", 1e6, force},
    Unit{"Pa", 1, pressure}, Unit{"kPa", 1e3, pressure}, Unit{"MPa", 1e6, pressure}, Unit{"GPa", 1e9, pressure},
    Unit{"TPa", 1e12, pressure}, Unit{"bar", 1e5, pressure},
    Unit{"psi", 6894.757293168361, pressure},  // 1 lbf / in^2, exact by the definitions of lb, g_n and inch
    Unit{"J", 1, energy}, Unit{"mJ", 1e-3, energy}, Unit{"kJ", 1e3, energy},
    Unit{"deg", std::numbers::pi / 180, none, true}, Unit{"rad", 1, none, true}, Unit{"%", 0.01, none}};

const Unit& find_unit(std::string_view name) {
    for (const Unit& unit : units)
        if (unit.name == name) return unit;
    throw std::invalid_argument(fmt::format("a known unit (not '{}')", name));
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Reads "UNIT^POWER" factors separated by blanks, '*', '/'.
class UnitScanner {
public:
    explicit UnitScanner(std::string_view text) : text_(text) {}

    void apply_to(Quantity& quantity) {
        double sign = 1;
        skip_blanks();
        while (at_ < text_.size()) {
            factor(quantity, sign);
            skip_blanks();
            if (at_ == text_.size()) return;
            sign = 1;
            if (text_[at_] == '*' || text_[at_] == '/') {
                sign = text_[at_] == '/' ? -1 : 1;
                ++at_;
                skip_blanks();
                if (at_ == text_.size()) throw std::invalid_argument(fmt::format("a unit after '{}'", text_[at_ - 1]));
            }
        }
    }

private:
    void skip_blanks() {
        while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    }

    void factor(Quantity& quantity, double sign) {
        const std::size_t begin = at_;
        while (at_ < text_.size() && text_.find_first_of(" \t*/^", at_) != at_) ++at_;
        std::string_view name = text_.substr(begin, at_ - begin);
        double power = sign;
        if (name.starts_with("sqrt(") && name.ends_with(")")) {
            name = name.substr(5, name.size() - 6);
            power *= 0.5;
        }
        power *= exponent();
        const Unit& unit = find_unit(name);
        quantity.value *= std::pow(unit.scale, power);
        quantity.dimension.mass += unit.dimension.mass * power;
        quantity.dimension.length += unit.dimension.length * power;
        quantity.dimension.time += unit.dimension.time * power;
        quantity.angle = quantity.angle || unit.angle;
    }

    double exponent() {
        if (at_ == text_.size() || text_[at_] != '^') return 1;
        ++at_;
        double power = 0;
        const char* begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), power);
        if (error != std::errc{} || !std::isfinite(power)) throw std::invalid_argument("a number after '^'");
        at_ += static_cast<std::size_t>(end - begin);
        return power;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

Quantity parse_quantity(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    if (text.starts_with('+')) text.remove_prefix(1);
    Quantity quantity;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), quantity.value);
    if (error != std::errc{} || !std::isfinite(quantity.value))
        throw std::invalid_argument(fmt::format("a finite number with a unit (not '{}')", text));
    UnitScanner(text.substr(static_cast<std::size_t>(end - text.data()))).apply_to(quantity);
    if (!std::isfinite(quantity.value)) throw std::invalid_argument("a value within the range of a double");
    return quantity;
}

std::string unit_name(Dimension d) {
    struct Named {
        Dimension dimension;
        const char* name;
    };
    const std::array named{Named{none, "1"}, Named{length, "m"}, Named{area, "m^2"}, Named{time, "s"}, Named{frequency, "Hz"},
                           Named{mass, "kg"}, Named{velocity, "m/s"}, Named{acceleration, "m/s^2"}, Named{density, "kg/m^3"},
                           Named{force, "N"}, Named{pressure, "Pa"}, Named{compliance, "1/Pa"}, Named{energy, "J"},
                           Named{energy_per_area, "J/m^2"}, Named{stress_intensity, "Pa m^0.5"}, Named{force_density, "N/m^3"}};
    for (const Named& entry : named)
        if (entry.dimension == d) return entry.name;
    return fmt::format("kg^{} m^{} s^{}", d.mass, d.length, d.time);
}

}  // namespace cleave
