#pragma once

#include "solver/input/table_reader.hpp"

#include <array>
#include <string>
#include <vector>

namespace cleave {

/// The integer at `key`. Throws InputError outside of least ... most (both included).
int read_integer(TableReader& reader, const std::string& key, int least, int most);

/// Three numbers, as they are: their length is not 1, but the root of their squares' sum neither overflows nor loses digits.
/// Throws InputError.
std::array<double, 3> read_direction(TableReader& reader, const std::string& key);

/// ["0.1 mm", "0.2 mm"], SI; one quantity counts as an array of one. Throws InputError, for another dimension too.
std::vector<double> read_quantities(TableReader& reader, const std::string& key, Dimension dimension);

}  // namespace cleave
