#pragma once

#include "validation/case_store.hpp"

#include <string>

namespace cleave::fuzz {

/// A finished case called "seed" with one row of each kind: with bands, ladder, artifacts and a convergence, and with as little as may be.
validation::FinishedCase finished_case();

/// A results.json that holds it.
std::string results_seed();

}  // namespace cleave::fuzz
