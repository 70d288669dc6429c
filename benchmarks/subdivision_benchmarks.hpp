#pragma once

#include "benchmarks/program_options.hpp"

namespace cleave::benchmarks {

/// Registers table2/... and subdivision/... Bodies are made when their first benchmark runs, not here.
void register_subdivision(Level level);

}  // namespace cleave::benchmarks
