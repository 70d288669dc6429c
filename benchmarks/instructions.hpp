#pragma once

#include <string>

namespace cleave::benchmarks {

/// The total of one event (instructions) in a callgrind output file's text. Throws EnvironmentError where there is none.
double counted_instructions(const std::string& callgrind_output);

}  // namespace cleave::benchmarks
