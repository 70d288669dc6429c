#include "validation/headline.hpp"

#include <cmath>

namespace cleave::validation {

namespace {

bool judged(const Row& row) { return row.verdict != Verdict::info && !row.must_fail; }

bool is_particle_stress(const Row& row) {
    return row.quantity == "stress" && row.side == Side::particles && row.reference_side == Side::fem && row.relative;
}
bool is_release_rate(const Row& row) { return row.quantity.starts_with("energy_release_rate") && row.relative && row.reference_side; }
bool is_crack_angle(const Row& row) { return row.unit == "deg" && !row.relative && row.reference_side; }

template <class Kind>
std::optional<WorstError> worst(const std::vector<CaseResult>& cases, Kind is_of_kind) {
    std::optional<WorstError> found;
    for (const CaseResult& of : cases)
        for (std::size_t i = 0; i < of.rows.size(); ++i) {
            const Row& row = of.rows[i];
            if (!judged(row) || !is_of_kind(row)) continue;
            const double error = row.relative ? row.measurement.relative_error : row.measurement.absolute_error;
            if (std::isfinite(error) && (!found || error > found->error)) found = WorstError{of.name, of.command, i, error};
        }
    return found;
}

}  // namespace

Headline headline(const std::vector<CaseResult>& cases) {
    return {worst(cases, is_particle_stress), worst(cases, is_release_rate), worst(cases, is_crack_angle)};
}

}  // namespace cleave::validation
