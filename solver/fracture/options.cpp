#include "solver/fracture/options.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace cleave::fracture {

namespace {

/// One of the named values of an enum, the one in `value` where the key is missing.
template <class Enum, std::size_t n>
void read_choice(TableReader& table, const std::string& key, const std::array<std::pair<const char*, Enum>, n>& names, Enum& value) {
    if (!table.has(key)) return;
    std::vector<std::string> words;
    for (const auto& [word, unused] : names) words.emplace_back(word);
    const std::string chosen = table.choice(key, words);
    for (const auto& [word, meant] : names)
        if (chosen == word) value = meant;
}

int read_count(TableReader& table, const std::string& key, int fallback, int least, int most) {
    const long count = table.integer_or(key, fallback);
    if (count < least || count > most) table.fail(key, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return static_cast<int>(count);
}

}  // namespace

Options paper_options() {
    Options options;
    options.criterion = Criterion::strain;
    options.grouping = Grouping::distance;
    options.group_gradient = GroupGradient::members;
    return options;
}

void read_options(TableReader& table, Options& options) {
    read_choice(table, "criterion", std::array{std::pair{"stress", Criterion::stress}, std::pair{"strain", Criterion::strain}},
                options.criterion);
    read_choice(table, "grouping",
                std::array{std::pair{"azimuth", Grouping::azimuth}, std::pair{"k_means", Grouping::k_means},
                           std::pair{"distance", Grouping::distance}},
                options.grouping);
    read_choice(table, "group_gradient",
                std::array{std::pair{"neighbourhoods", GroupGradient::neighbourhoods}, std::pair{"members", GroupGradient::members}},
                options.group_gradient);
    read_choice(table, "outer_radius",
                std::array{std::pair{"proportional", OuterRadius::proportional}, std::pair{"balance", OuterRadius::balance}},
                options.outer_radius);
    options.groups = read_count(table, "groups", options.groups, 1, 1000);
    options.interface_crossings = read_count(table, "interface_crossings", options.interface_crossings, 0, 100);
    options.contact_area_exponent = table.number_or("contact_area_exponent", options.contact_area_exponent);
    options.energy_limit = table.quantity_or("energy_limit", Dimension{1, -1, -2}, options.energy_limit);
    if (options.energy_limit < 0) table.fail("energy_limit", "a value of at least zero");
}

}  // namespace cleave::fracture
