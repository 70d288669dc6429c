#pragma once

#include "solver/subdivision/subdivided.hpp"

#include <string>

namespace cleave::subdivision::test {

/// The name of the first field in which two results differ in a bit; empty where they are equal.
std::string first_difference(const Subdivided& a, const Subdivided& b);

}  // namespace cleave::subdivision::test
