#pragma once

#include "validation/results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace cleave::validation {

/// The worst of a kind among the judged rows of a run, and where it stands.
struct WorstError {
    std::string case_name, command;
    std::size_t row = 0;  ///< of that case
    double error = 0;     ///< relative; of a crack angle: degrees
};

/// What a reader asks first. Judged rows only, without must-fail twins; none where no row is of that kind.
struct Headline {
    std::optional<WorstError> particle_stress;      ///< stress of the particles against the finite elements
    std::optional<WorstError> energy_release_rate;  ///< of any solver
    std::optional<WorstError> crack_angle;          ///< of any solver: kinks, principal directions
};
Headline headline(const std::vector<CaseResult>& cases);

}  // namespace cleave::validation
