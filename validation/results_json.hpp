#pragma once

#include "validation/results.hpp"
#include "validation/solve_note.hpp"

#include <nlohmann/json.hpp>

namespace cleave::validation {

/// Results as JSON values and back; numbers keep every bit, NaN is null. For results.cpp, timings.cpp and the store of finished cases.
using Json = nlohmann::ordered_json;

Json case_json(const CaseResult& result);
/// The inverse of case_json, but for the error's other kind (relative or absolute), which is not kept. Throws nlohmann::json::exception.
CaseResult case_of(const Json& json);

Json note_json(const SolveNote& note);
SolveNote note_of(const Json& json);

}  // namespace cleave::validation
