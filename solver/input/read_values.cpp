#include "solver/input/read_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace cleave {

int read_integer(TableReader& reader, const std::string& key, int least, int most) {
    const long value = reader.integer(key);
    if (value < least || value > most) reader.fail(key, fmt::format("an integer from {} to {}", least, most));
    return static_cast<int>(value);
}

std::array<double, 3> read_direction(TableReader& reader, const std::string& key) {
    constexpr double shortest = 1e-100, longest = 1e100;
    const std::vector<double> entries = reader.numbers(key);
    if (entries.size() != 3) reader.fail(key, "three numbers, not all zero");
    const double length = std::hypot(entries[0], entries[1], entries[2]);
    if (!(length > 0)) reader.fail(key, "three numbers, not all zero");
    if (!(length >= shortest && length <= longest)) reader.fail(key, fmt::format("a direction of length {:g} to {:g}", shortest, longest));
    return {entries[0], entries[1], entries[2]};
}

std::vector<double> read_quantities(TableReader& reader, const std::string& key, Dimension dimension) {
    std::vector<double> values;
    for (const std::string& text : reader.strings(key)) {
        const Quantity quantity = [&] {
            try {
                return parse_quantity(text);
            } catch (const std::invalid_argument& error) {
                reader.fail(key, error.what());
            }
        }();
        if (!(quantity.dimension == dimension) || quantity.angle)
            reader.fail(key, fmt::format("quantities in {} (not '{}')", unit_name(dimension), text));
        values.push_back(quantity.value);
    }
    return values;
}

}  // namespace cleave
