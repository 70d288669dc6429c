#pragma once

#include "validation/results.hpp"
#include "validation/solve_note.hpp"

#include <nlohmann/json.hpp>

namespace cleave::validation {

/// Results as JSON values and back; numbers keep every bit, NaN is null. For results.cpp, timings.cpp and the store of finished cases.
using Json = nlohmann::ordered_json;

/// {worst_particle_stress, worst_energy_release_rate, worst_crack_angle}: the number, its case, its check and its command, or null.
Json headline_json(const std::vector<CaseResult>& cases);

/// The matrix symmetry class x quantity x method: cells with their checks and cases, or why they are empty.
Json coverage_json(const std::vector<CaseResult>& cases);

Json case_json(const CaseResult& result);
/// The inverse of case_json, but for the error's other kind (relative or absolute), which is not kept. Throws nlohmann::json::exception.
CaseResult case_of(const Json& json);

Json note_json(const SolveNote& note);
SolveNote note_of(const Json& json);

}  // namespace cleave::validation
