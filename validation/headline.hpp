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

/// The largest of a kind among the differences that no band of their case judges, and why none does.
struct RecordedError {
    std::string case_name, command;
    std::size_t row = 0;         ///< of that case: the row it was measured with
    double error = 0;            ///< relative
    std::string solver, against;
    std::string why;
};

/// What a reader asks first. Judged rows only, without must-fail twins, and beside the first what was only recorded; none where no row is
/// of that kind.
struct Headline {
    std::optional<WorstError> particle_stress;      ///< stress of the particles against the finite elements
    std::optional<WorstError> energy_release_rate;  ///< of any solver
    std::optional<WorstError> crack_angle;          ///< of any solver: kinks, principal directions
    std::optional<RecordedError> recorded_particle_stress = std::nullopt;  ///< as particle_stress, of rows for information and beside judged ones
};
Headline headline(const std::vector<CaseResult>& cases);

}  // namespace cleave::validation
