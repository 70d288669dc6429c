#include "validation/headline.hpp"

#include <fmt/format.h>

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

/// Why no band judges a difference from the finite elements that `row` measured.
std::string why_recorded(const Row& row) {
    if (judged(row)) return fmt::format("{} is judged against {}", row.solver, row.reference_source);
    return row.basis.empty() ? fmt::format("the case sets no band for {}", row.solver) : row.basis;
}

/// Stress of the particles against the finite elements where nothing judges it: rows without a band, and the sides that a row's check does
/// not name. Must-fail twins repeat another row's measurement.
std::optional<RecordedError> largest_recorded(const std::vector<CaseResult>& cases) {
    std::optional<RecordedError> found;
    for (const CaseResult& of : cases)
        for (std::size_t i = 0; i < of.rows.size(); ++i) {
            const Row& row = of.rows[i];
            const auto take = [&](double error, const std::string& against) {
                if (std::isfinite(error) && (!found || error > found->error))
                    found = RecordedError{of.name, of.command, i, error, row.solver, against, why_recorded(row)};
            };
            if (row.must_fail || row.quantity != "stress" || row.side != Side::particles) continue;
            if (!judged(row) && is_particle_stress(row)) take(row.measurement.relative_error, row.reference_source);
            for (const Also& also : row.also)
                if (also.side == Side::fem && also.relative) take(also.error, also.source);
        }
    return found;
}

}  // namespace

Headline headline(const std::vector<CaseResult>& cases) {
    return {worst(cases, is_particle_stress), worst(cases, is_release_rate), worst(cases, is_crack_angle), largest_recorded(cases)};
}

}  // namespace cleave::validation
