#include "validation/runner.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "validation/adapters/level.hpp"
#include "validation/analytic/principals.hpp"
#include "validation/case_checks.hpp"
#include "validation/front_profile.hpp"
#include "validation/ladder.hpp"
#include "validation/profile.hpp"
#include "validation/solutions.hpp"
#include "validation/stress_field.hpp"
#include "validation/study_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace cleave::validation {

namespace {

std::string reference_source(const Check& check, const Case& of) {
    switch (check.reference.kind) {
        case Reference::Kind::solution: return make_field(*check.reference.solution, of).source;
        case Reference::Kind::none: return "";
        default: return check.reference.source;
    }
}

/// Compared as a field, by a norm.
bool is_field(const Check& check) {
    return check.at.empty() && !is_scalar(check.observable.quantity) && !is_front_quantity(check.observable.quantity);
}

/// The rows of a check: one per solver and place.
std::vector<Row> empty_rows(const Check& check, const Case& of) {
    std::vector<Row> rows;
    const std::size_t places = std::max<std::size_t>(1, check.at.size());
    for (const std::string& solver : check.solvers)
        for (std::size_t place = 0; place < places; ++place) {
            Row row;
            row.case_name = of.name;
            row.tier = of.tier;
            row.quantity = check.observable.quantity;
            row.component = check.observable.component;
            row.unit = check.angle ? "deg" : unit_name(check.unit);
            row.solver = solver;
            row.side = of.side(solver);
            row.reference_side = reference_side(check, of);
            row.reference_source = reference_source(check, of);
            row.band = check.band(solver);
            row.relative = !row.band.absolute && !(check.reference.kind == Reference::Kind::value && check.reference.value == 0);
            if (!row.band.empty() || check.bands.empty()) row.basis = check.basis;
            row.must_fail = check.must_fail;
            if (is_field(check)) row.norm = check.norm;
            if (is_scalar(check.observable.quantity))
                row.place = "whole body";
            else if (is_front_quantity(check.observable.quantity))
                row.place = fmt::format("front near ({}, {}, {}) m", check.at[place][0], check.at[place][1], check.at[place][2]);
            else if (check.at.empty())
                row.place = check.norm + (check.region.empty() ? " over the body" : " over " + check.region);
            else
                row.place = fmt::format("at ({}, {}, {}) m", check.at[place][0], check.at[place][1], check.at[place][2]);
            rows.push_back(std::move(row));
        }
    return rows;
}

Samples restrict_to(const Samples& all, const Region& region) {
    Samples chosen;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!region.contains(all.position[i])) continue;
        chosen.position.push_back(all.position[i]);
        chosen.weight.push_back(all.weight[i]);
        chosen.displacement.push_back(all.displacement[i]);
        chosen.strain.push_back(all.strain[i]);
        chosen.stress.push_back(all.stress[i]);
    }
    return chosen;
}

analytic::Field reference_field(const Check& check, const Case& of) {
    analytic::Field field = make_field(*check.reference.solution, of);
    if (!field.stress) throw std::invalid_argument("a solution that gives fields");
    return field;
}

Samples reference_samples(const Check& check, LevelSources& sources, const std::vector<Point>& points) {
    if (check.reference.kind == Reference::Kind::solution) return evaluate(reference_field(check, sources.of()), points);
    return sources.get(check.reference.source).inside(points);
}

Measurement measure_field(const Check& check, const std::string& solver, LevelSources& sources) {
    const FieldSource& source = sources.get(solver);
    const Samples method = restrict_to(source.everywhere(), Region(check.region, region_names(*sources.of().shape, source.resolution().size)));
    Measurement measurement;
    if (check.reference.kind == Reference::Kind::none) {
        // Compared with itself: only the norm of the field is of interest.
        measurement.value = compare(check.observable, method, method, check.norm).value / check.divide_by;
        measurement.relative_error = measurement.absolute_error = std::nan("");
        return measurement;
    }
    const FieldError error = compare(check.observable, method, reference_samples(check, sources, method.position), check.norm);
    measurement.value = error.value / check.divide_by;
    measurement.reference = error.reference / check.divide_by;
    measurement.relative_error = error.error;
    measurement.absolute_error = error.error * error.reference / check.divide_by;
    return measurement;
}

void set_errors(Measurement& measurement) {
    if (!measurement.reference) {
        measurement.relative_error = measurement.absolute_error = std::nan("");
        return;
    }
    measurement.absolute_error = std::abs(*measurement.value - *measurement.reference);
    measurement.relative_error = measurement.absolute_error / std::abs(*measurement.reference);
}

double magnitude(const std::vector<double>& components) {
    if (components.size() == 1) return components[0];
    double square = 0;
    for (const double c : components) square += c * c;
    return std::sqrt(square);
}

Measurement measure_point(const Check& check, const std::string& solver, const Point& point, LevelSources& sources) {
    Measurement measurement;
    const auto value_of = [&](const Samples& samples) { return magnitude(observe(check.observable, samples, 0)) / check.divide_by; };
    const Samples method = sources.get(solver).at({point});
    measurement.value = value_of(method);
    if (check.reference.kind == Reference::Kind::value) measurement.reference = check.reference.value;
    if (check.reference.kind == Reference::Kind::solver) measurement.reference = value_of(sources.get(check.reference.source).at({point}));
    if (check.reference.kind == Reference::Kind::solution)
        measurement.reference = value_of(evaluate(reference_field(check, sources.of()), {point}));
    set_errors(measurement);
    return measurement;
}

Measurement measure_scalar(const Check& check, const std::string& solver, LevelSources& sources) {
    Measurement measurement;
    const auto shown = [&](double value) { return (check.angle ? degrees(value) : value) / check.divide_by; };
    measurement.value = shown(sources.get(solver).scalar(check.observable.quantity));
    if (check.reference.kind == Reference::Kind::value) measurement.reference = check.reference.value;
    if (check.reference.kind == Reference::Kind::solver)
        measurement.reference = shown(sources.get(check.reference.source).scalar(check.observable.quantity));
    if (check.reference.kind == Reference::Kind::solution) {
        const analytic::Field field = make_field(*check.reference.solution, sources.of());
        const auto scalar = field.scalars.find(check.observable.quantity);
        if (scalar == field.scalars.end()) throw std::invalid_argument("a solution that gives the quantity " + check.observable.quantity);
        measurement.reference = shown(scalar->second);
    }
    set_errors(measurement);
    return measurement;
}

/// A quantity of the crack's front, at the place nearest to `point`.
Measurement measure_front(const Check& check, const std::string& solver, const Point& point, LevelSources& sources) {
    Measurement measurement;
    const auto shown = [&](double value) { return (check.angle ? degrees(value) : value) / check.divide_by; };
    measurement.value = shown(sources.get(solver).at_front(check.observable.quantity, check.observable.component, point));
    if (check.reference.kind == Reference::Kind::value) measurement.reference = check.reference.value;
    if (check.reference.kind == Reference::Kind::solver)
        measurement.reference = shown(sources.get(check.reference.source).at_front(check.observable.quantity, check.observable.component, point));
    if (check.reference.kind == Reference::Kind::solution) {
        const analytic::Field field = make_field(*check.reference.solution, sources.of());
        if (!field.at_front) throw std::invalid_argument("a solution that gives the quantity " + check.observable.quantity);
        measurement.reference = shown(field.at_front(check.observable.quantity, check.observable.component, point));
    }
    set_errors(measurement);
    return measurement;
}

/// The direction's angle from an axis, deg, or the gap.
double principal_value(const Check& check, const PrincipalAxis& principal) {
    if (check.observable.quantity == "principal_gap") return principal.gap / check.divide_by;
    const double cosine = std::abs(principal.direction[static_cast<std::size_t>(check.observable.component[0] - 'x')]);
    return degrees(std::acos(std::min(1.0, cosine))) / check.divide_by;
}

Measurement measure_principal(const Check& check, const std::string& solver, const Point& point, LevelSources& sources) {
    Measurement measurement;
    measurement.value = principal_value(check, sources.get(solver).principal_stress(point));
    if (check.reference.kind == Reference::Kind::value) measurement.reference = check.reference.value;
    if (check.reference.kind == Reference::Kind::solver)
        measurement.reference = principal_value(check, sources.get(check.reference.source).principal_stress(point));
    if (check.reference.kind == Reference::Kind::solution) {
        const analytic::Principals exact = analytic::principals(analytic::stress_tensor(reference_field(check, sources.of()).stress(point)));
        measurement.reference = principal_value(check, {exact.direction[0], exact.gap()});
    }
    set_errors(measurement);
    return measurement;
}

Measurement measure(const Check& check, const std::string& solver, std::size_t place, LevelSources& sources) {
    try {
        if (is_principal_quantity(check.observable.quantity)) return measure_principal(check, solver, check.at[place], sources);
        if (is_front_quantity(check.observable.quantity)) return measure_front(check, solver, check.at[place], sources);
        if (is_scalar(check.observable.quantity)) return measure_scalar(check, solver, sources);
        if (check.at.empty()) return measure_field(check, solver, sources);
        return measure_point(check, solver, check.at[place], sources);
    } catch (const std::invalid_argument& error) {
        sources.of().fail(check.where, error.what());
    }
}

/// Adds one size of the ladder to the rows of a check.
void add_step(const Check& check, std::vector<Row>& rows, LevelSources& sources) {
    const std::size_t places = std::max<std::size_t>(1, check.at.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Row& row = rows[i];
        row.measurement = measure(check, row.solver, i % places, sources);
        row.resolution = sources.get(row.solver).resolution();
        row.ladder.push_back({row.resolution, row.relative ? row.measurement.relative_error : row.measurement.absolute_error, row.measurement.value});
    }
}

/// The solution that the case's fields have in mathematics: the first one that a check in earnest names.
const Reference* field_solution(const Case& of) {
    for (const Check& check : of.checks)
        if (!check.must_fail && check.reference.kind == Reference::Kind::solution && make_field(*check.reference.solution, of).stress) return &check.reference;
    return nullptr;
}

void measure_other_side(const Check& check, const Reference& other, std::size_t place, LevelSources& sources, Row& row) {
    Check beside = check;
    beside.reference = other;
    try {
        const Measurement measured = measure(beside, row.solver, place, sources);
        const bool relative = !check.angle && std::isfinite(measured.relative_error);
        if (!relative && !std::isfinite(measured.absolute_error)) return;
        const bool fem = other.kind == Reference::Kind::solver;
        row.also.push_back({fem ? Side::fem : Side::mathematics, fem ? other.source : make_field(*other.solution, sources.of()).source,
                            measured.reference, relative ? measured.relative_error : measured.absolute_error, relative});
    } catch (const InputError&) {
        // the other side has no such value there: the line of the comparison stays without it
    }
}

/// Fields on the finest mesh against the sides that their check does not name, where the case has them at hand.
void measure_other_sides(const Case& of, std::vector<std::vector<Row>>& rows, LevelSources& sources) {
    const Reference* mathematics = field_solution(of);
    std::optional<Reference> fem;
    for (const char* solver : {"fem.p1", "fem.p2"})
        if (sources.find(solver)) fem = Reference{Reference::Kind::solver, 0, solver, {}};
    for (std::size_t c = 0; c < of.checks.size(); ++c) {
        const Check& check = of.checks[c];
        if (check.must_fail || is_scalar(check.observable.quantity) || is_front_quantity(check.observable.quantity)) continue;
        for (std::size_t i = 0; i < rows[c].size(); ++i) {
            Row& row = rows[c][i];
            if (row.ladder.empty() || row.resolution.size != sources.get(row.solver).resolution().size) continue;  // ended earlier
            const std::size_t place = i % std::max<std::size_t>(1, check.at.size());
            if (fem && row.side == Side::particles && row.reference_side != Side::fem) measure_other_side(check, *fem, place, sources, row);
            if (mathematics && row.reference_side != Side::mathematics) measure_other_side(check, *mathematics, place, sources, row);
        }
    }
}

/// Meshes whose parts refine differently have no order over N^(-1/3); there a quantity of the crack's front, which the elements at the front
/// decide, has one over their size, where it is asked for.
OrderOver order_over(const Row& row, bool uniform) {
    if (is_front_quantity(row.quantity)) return row.band.order_at_least ? OrderOver::size : OrderOver::none;
    return uniform && !is_scalar(row.quantity) ? OrderOver::count : OrderOver::none;
}

void conclude(Row& row, bool uniform) {
    finish_ladder(row, order_over(row, uniform));
    row.verdict = judge(row.measurement, row.band, row.must_fail);
}

/// To the first row that suits, else to the first of all.
template <class Suits>
void attach(std::vector<Row>& rows, const Artifact& artifact, const Suits& suits) {
    for (Row& row : rows)
        if (!row.must_fail && suits(row)) return row.artifacts.push_back(artifact);
    if (!rows.empty()) rows.front().artifacts.push_back(artifact);
}

bool of_elements(const Row& row) { return row.side == Side::fem; }
bool of_particle_stress(const Row& row) { return row.side == Side::particles && row.quantity == "stress"; }

/// The fields of the best finite elements that the case used, for ParaView.
std::optional<Artifact> write_fields(const Case& of, const LevelSources& sources, const std::filesystem::path& out) {
    for (const char* solver : {"fem.p2", "fem.p1"})
        if (const FieldSource* source = sources.find(solver)) {
            const std::string file = fmt::format("{}/{}.vtu", artifact_folder(of.name), solver);
            write_file_atomic(out / file, source->vtu());
            return Artifact{file, fmt::format("Displacement, stress, strain and estimated error, {}", solver), "", ""};
        }
    return std::nullopt;
}

}  // namespace

Verdict overall(const std::vector<Row>& rows) {
    Verdict verdict = Verdict::info;
    for (const Row& row : rows) {
        if (row.verdict == Verdict::fail) return Verdict::fail;
        if (row.verdict == Verdict::pass) verdict = Verdict::pass;
    }
    return verdict;
}

std::string artifact_folder(std::string text) {
    for (char& c : text)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-' && c != '.' && c != '=') c = '_';
    return text;
}

CaseRun run_case(const Case& of, const RunOptions& options) {
    if (of.study) return run_study(of, options);
    CaseRun run;
    run.result = {of.name, of.tier, of.about, "", of.parameters, {}, Verdict::info, of.symmetry()};
    std::vector<std::vector<Row>> rows;
    for (const Check& check : of.checks) rows.push_back(empty_rows(check, of));
    const std::vector<double>& sizes = of.sizes(options.level);
    std::vector<std::pair<const Profile*, Artifact>> drawn;
    std::optional<Artifact> fields, stress;
    std::vector<Artifact> fronts;
    for (const double size : sizes) {
        LevelSources sources(of, size, options.out / "meshes");
        for (std::size_t c = 0; c < of.checks.size(); ++c)
            if (of.checks[c].takes(size, sizes)) add_step(of.checks[c], rows[c], sources);
        if (size == sizes.back()) measure_other_sides(of, rows, sources);
        if (size == sizes.back())
            for (std::size_t p = 0; p < of.profiles.size(); ++p)
                drawn.emplace_back(&of.profiles[p], write_profile(of.profiles[p], fmt::format("{}/profile_{}.csv", artifact_folder(of.name), p + 1), options.out, sources));
        if (size == sizes.back()) {
            fields = write_fields(of, sources, options.out);
            stress = write_stress_field(artifact_folder(of.name), options.out, sources);
            fronts = write_fronts(of, sources, artifact_folder(of.name), options.out);
        }
        run.solves.insert(run.solves.end(), sources.notes().begin(), sources.notes().end());
        if (options.progress) options.progress(fmt::format("{} size {:.4g} m", of.name, size));
    }
    for (std::vector<Row>& of_check : rows)
        for (Row& row : of_check) {
            if (row.ladder.empty()) continue;  // a check for a size that this ladder does not have
            conclude(row, of.shape->uniform_refinement());
            run.result.rows.push_back(std::move(row));
        }
    for (const auto& [profile, artifact] : drawn)
        attach(run.result.rows, artifact, [&profile = profile](const Row& row) { return row.quantity == profile->observable.quantity; });
    if (fields) attach(run.result.rows, *fields, of_elements);
    if (stress) attach(run.result.rows, *stress, of_particle_stress);
    for (const Artifact& front : fronts) attach(run.result.rows, front, of_elements);
    run.result.verdict = overall(run.result.rows);
    return run;
}

}  // namespace cleave::validation
