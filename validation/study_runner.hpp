#pragma once

#include "validation/runner.hpp"

namespace cleave::validation {

/// Runs the study of a case and judges its checks: one row per solver and place. A check that finds no value, or no reference at the same
/// place, is an InputError. Called by run_case.
CaseRun run_study(const Case& of, const RunOptions& options);

}  // namespace cleave::validation
