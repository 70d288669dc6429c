#include "validation/study_runner.hpp"

#include "validation/case_checks.hpp"
#include "validation/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cleave::validation {

namespace {

/// The values of one quantity, method and place, coarse to fine.
using Ladder = std::vector<const StudyValue*>;

Ladder ladder_of(const StudyOutcome& outcome, const std::string& quantity, const std::string& method, const std::string& place) {
    Ladder ladder;
    for (const StudyValue& value : outcome.values)
        if (value.quantity == quantity && value.method == method && value.place == place) ladder.push_back(&value);
    return ladder;
}

/// In the order in which the study first met them.
std::vector<std::string> places_of(const StudyOutcome& outcome, const std::string& quantity, const std::string& method) {
    std::vector<std::string> places;
    for (const StudyValue& value : outcome.values)
        if (value.quantity == quantity && value.method == method && std::find(places.begin(), places.end(), value.place) == places.end())
            places.push_back(value.place);
    return places;
}

double shown(double value, const Check& check) {
    return (check.angle ? degrees(value) : value) / check.divide_by;
}

std::optional<double> reference_of(const Check& check, const StudyOutcome& outcome, const std::string& place, std::size_t step, const Case& of) {
    if (check.reference.kind == Reference::Kind::none) return std::nullopt;
    if (check.reference.kind == Reference::Kind::value) return check.reference.value;
    const Ladder ladder = ladder_of(outcome, check.observable.quantity, check.reference.source, place);
    if (ladder.empty())
        of.fail(check.where + ".reference.solver", fmt::format("a method with a value of {} at '{}'", check.observable.quantity, place));
    return shown(ladder[std::min(step, ladder.size() - 1)]->value, check);
}

Measurement measure(double value, const std::optional<double>& reference) {
    Measurement measurement;
    measurement.value = value;
    measurement.reference = reference;
    measurement.absolute_error = reference ? std::abs(value - *reference) : std::nan("");
    measurement.relative_error = reference ? measurement.absolute_error / std::abs(*reference) : std::nan("");
    return measurement;
}

Row empty_row(const Check& check, const std::string& solver, const std::string& place, const Case& of) {
    Row row;
    row.case_name = of.name;
    row.tier = of.tier;
    row.quantity = check.observable.quantity;
    row.unit = check.angle ? "deg" : unit_name(check.unit);
    row.solver = solver;
    row.place = place.empty() ? "study" : place;
    row.side = of.side(solver);
    row.reference_side = reference_side(check, of);
    row.reference_source = check.reference.source;
    row.band = check.band(solver);
    row.relative = !row.band.absolute && !(check.reference.kind == Reference::Kind::value && check.reference.value == 0);
    if (!row.band.empty() || check.bands.empty()) row.basis = check.basis;
    row.must_fail = check.must_fail;
    return row;
}

Row judged_row(const Check& check, const std::string& solver, const std::string& place, const StudyOutcome& outcome, const Case& of) {
    Row row = empty_row(check, solver, place, of);
    const Ladder ladder = ladder_of(outcome, check.observable.quantity, solver, place);
    for (std::size_t step = 0; step < ladder.size(); ++step) {
        row.measurement = measure(shown(ladder[step]->value, check), reference_of(check, outcome, place, step, of));
        row.resolution = ladder[step]->resolution;
        row.detail = ladder[step]->detail;
        row.ladder.push_back({row.resolution, row.relative ? row.measurement.relative_error : row.measurement.absolute_error, row.measurement.value});
    }
    finish_ladder(row, OrderOver::none);
    row.verdict = judge(row.measurement, row.band, row.must_fail);
    return row;
}

void add_rows(const Check& check, const StudyOutcome& outcome, const Case& of, std::vector<Row>& rows) {
    for (const std::string& solver : check.solvers) {
        const std::vector<std::string> known = places_of(outcome, check.observable.quantity, solver);
        if (known.empty()) of.fail(check.where + ".solver", fmt::format("a method that measures {} (not '{}')", check.observable.quantity, solver));
        for (const std::string& place : check.places.empty() ? known : check.places) {
            if (std::find(known.begin(), known.end(), place) == known.end())
                of.fail(check.where + ".place", fmt::format("one of {} (not '{}')", fmt::join(known, ", "), place));
            rows.push_back(judged_row(check, solver, place, outcome, of));
        }
    }
}

}  // namespace

CaseRun run_study(const Case& of, const RunOptions& options) {
    CaseRun run;
    run.result = {of.name, of.tier, of.about, "", of.parameters, {}, Verdict::info, of.symmetry()};
    const StudyOutcome outcome = of.study->run({options.level, options.out, options.out / "meshes", artifact_folder(of.name), {}});
    for (const Check& check : of.checks) add_rows(check, outcome, of, run.result.rows);
    if (!run.result.rows.empty()) run.result.rows.front().artifacts = outcome.artifacts;
    run.result.verdict = overall(run.result.rows);
    run.solves = outcome.solves;
    if (options.progress) options.progress(of.name);
    return run;
}

}  // namespace cleave::validation
