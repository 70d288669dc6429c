#include "validation/results_json.hpp"

#include "validation/comparison.hpp"
#include "validation/coverage.hpp"
#include "validation/headline.hpp"

#include <cmath>
#include <limits>

namespace cleave::validation {

namespace {

/// JSON has no NaN: an undefined number is null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }
Json number(const std::optional<double>& value) { return value ? number(*value) : Json(); }

Json band_json(const Band& band) {
    if (band.empty()) return nullptr;
    Json json = Json::object();
    if (band.relative) json["relative"] = *band.relative;
    if (band.absolute) json["absolute"] = *band.absolute;
    if (band.order_at_least) json["order_at_least"] = *band.order_at_least;
    if (band.side != BandSide::either) json["side"] = name(band.side);
    return json;
}

Json resolution_json(const Resolution& resolution) {
    Json json{{"size", number(resolution.size)}, {"unit", "m"}};
    if (resolution.particles > 0) json["particles"] = resolution.particles;
    if (resolution.dofs > 0) json["dofs"] = resolution.dofs;
    return json;
}

double error_of(const Row& row) { return row.relative ? row.measurement.relative_error : row.measurement.absolute_error; }

Json convergence_json(const std::optional<Convergence>& one) {
    if (!one) return nullptr;
    return {{"order", number(one->order)}, {"order_of_values", number(one->order_of_values)}, {"extrapolated", number(one->extrapolated)},
            {"uncertainty", number(one->uncertainty)}, {"asymptotic", one->asymptotic}, {"why", one->why}};
}

Json statement_json(const std::optional<Statement>& one) { return one ? Json{{"by", one->by}, {"value", number(one->value)}} : Json(); }

Json difference_json(const std::optional<Difference>& one) {
    if (!one) return nullptr;
    return {{"error", number(one->error)}, {"error_kind", one->relative ? "relative" : "absolute"}, {"check", one->row ? Json(*one->row) : Json()}};
}

Json comparison_json(const Comparison& line) {
    return {{"quantity", line.quantity}, {"component", line.component}, {"unit", line.unit}, {"place", line.place},
            {"particles", statement_json(line.particles)}, {"fem", statement_json(line.fem)}, {"mathematics", statement_json(line.mathematics)},
            {"particles_fem", difference_json(line.particles_fem)}, {"particles_mathematics", difference_json(line.particles_mathematics)},
            {"fem_mathematics", difference_json(line.fem_mathematics)}, {"checks", line.rows}};
}

Json row_json(const Row& row) {
    Json json{{"case", row.case_name}, {"tier", row.tier}, {"quantity", row.quantity}, {"component", row.component}, {"unit", row.unit},
              {"place", row.place}, {"solver", row.solver}, {"resolution", resolution_json(row.resolution)},
              {"value", number(row.measurement.value)}, {"reference", number(row.measurement.reference)},
              {"reference_source", row.reference_source}, {"error", number(error_of(row))},
              {"error_kind", row.relative ? "relative" : "absolute"}, {"band", band_json(row.band)}, {"basis", row.basis},
              {"order", number(row.measurement.order)}, {"must_fail", row.must_fail}, {"verdict", name(row.verdict)},
              {"norm", row.norm}, {"side", name(row.side)},
              {"reference_side", row.reference_side ? Json(name(*row.reference_side)) : Json()}, {"convergence", convergence_json(row.convergence)}};
    if (!row.detail.empty()) json["detail"] = row.detail;
    json["ladder"] = Json::array();
    for (const LadderStep& step : row.ladder) {
        Json entry = resolution_json(step.resolution);
        entry["error"] = number(step.error);
        entry["value"] = number(step.value);
        entry["h"] = number(step.h);
        json["ladder"].push_back(entry);
    }
    json["also"] = Json::array();
    for (const Also& also : row.also)
        json["also"].push_back({{"side", name(also.side)}, {"source", also.source}, {"value", number(also.value)}, {"error", number(also.error)},
                                {"error_kind", also.relative ? "relative" : "absolute"}});
    json["artifacts"] = Json::array();
    for (const Artifact& a : row.artifacts) json["artifacts"].push_back({{"file", a.file}, {"title", a.title}, {"x", a.x}, {"y", a.y}});
    return json;
}

/// A double beyond the integers' range would be undefined behaviour. Throws where the number is none.
long integer_of(const Json& json) { return json.get_ref<const Json::number_integer_t&>(); }
long integer_or_zero(const Json& json, const char* key) { return json.contains(key) ? integer_of(json.at(key)) : 0; }

double number_of(const Json& json) { return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>(); }

std::optional<double> optional_of(const Json& json) { return json.is_null() ? std::nullopt : std::optional<double>(json.get<double>()); }

Band band_of(const Json& json) {
    Band band;
    if (json.is_null()) return band;
    if (json.contains("relative")) band.relative = json["relative"].get<double>();
    if (json.contains("absolute")) band.absolute = json["absolute"].get<double>();
    if (json.contains("order_at_least")) band.order_at_least = json["order_at_least"].get<double>();
    if (json.contains("side")) band.side = json["side"] == "below" ? BandSide::below : BandSide::above;
    return band;
}

Resolution resolution_of(const Json& json) { return {number_of(json.at("size")), integer_or_zero(json, "particles"), integer_or_zero(json, "dofs")}; }

Verdict verdict_of(const std::string& text) { return text == "pass" ? Verdict::pass : text == "fail" ? Verdict::fail : Verdict::info; }

Side side_of(const Json& json) { return json == "fem" ? Side::fem : json == "mathematics" ? Side::mathematics : Side::particles; }

std::optional<Convergence> convergence_of(const Json& json) {
    if (json.is_null()) return std::nullopt;
    return Convergence{optional_of(json.at("order")), optional_of(json.at("order_of_values")), optional_of(json.at("extrapolated")),
                       optional_of(json.at("uncertainty")), json.at("asymptotic"), json.at("why")};
}

LadderStep step_of(const Json& json) {
    return {resolution_of(json), number_of(json.at("error")), optional_of(json.at("value")), number_of(json.at("h"))};
}

Row row_of(const Json& json) {
    Row row;
    row.case_name = json.at("case");
    row.tier = json.at("tier");
    row.quantity = json.at("quantity");
    row.component = json.at("component");
    row.unit = json.at("unit");
    row.place = json.at("place");
    row.solver = json.at("solver");
    row.resolution = resolution_of(json.at("resolution"));
    row.relative = json.at("error_kind") == "relative";
    row.measurement = {optional_of(json.at("value")), optional_of(json.at("reference")), 0, 0, optional_of(json.at("order"))};
    (row.relative ? row.measurement.relative_error : row.measurement.absolute_error) = number_of(json.at("error"));
    row.reference_source = json.at("reference_source");
    row.band = band_of(json.at("band"));
    row.basis = json.at("basis");
    row.must_fail = json.at("must_fail");
    for (const Json& step : json.at("ladder")) row.ladder.push_back(step_of(step));
    for (const Json& a : json.at("artifacts")) row.artifacts.push_back({a.at("file"), a.at("title"), a.at("x"), a.at("y")});
    row.verdict = verdict_of(json.at("verdict"));
    row.norm = json.at("norm");
    row.detail = json.value("detail", "");
    row.side = side_of(json.at("side"));
    if (!json.at("reference_side").is_null()) row.reference_side = side_of(json.at("reference_side"));
    row.convergence = convergence_of(json.at("convergence"));
    for (const Json& one : json.at("also"))
        row.also.push_back({side_of(one.at("side")), one.at("source"), optional_of(one.at("value")), number_of(one.at("error")), one.at("error_kind") == "relative"});
    return row;
}

}  // namespace

Json headline_json(const std::vector<CaseResult>& cases) {
    const auto one = [](const std::optional<WorstError>& worst) {
        return worst ? Json{{"error", worst->error}, {"case", worst->case_name}, {"check", worst->row}, {"command", worst->command}} : Json();
    };
    const auto recorded = [](const std::optional<RecordedError>& largest) {
        return largest ? Json{{"error", largest->error}, {"case", largest->case_name}, {"check", largest->row}, {"command", largest->command},
                              {"solver", largest->solver}, {"against", largest->against}, {"why", largest->why}}
                       : Json();
    };
    const Headline found = headline(cases);
    return {{"worst_particle_stress", one(found.particle_stress)}, {"worst_energy_release_rate", one(found.energy_release_rate)},
            {"worst_crack_angle", one(found.crack_angle)}, {"recorded_particle_stress", recorded(found.recorded_particle_stress)}};
}

Json coverage_json(const std::vector<CaseResult>& cases) {
    Json json = Json::array();
    for (const CoverageCell& cell : coverage(cases)) {
        Json one{{"symmetry", cell.symmetry}, {"family", cell.family}, {"method", name(cell.method)}, {"checks", cell.checks}};
        if (cell.checks > 0)
            one["cases"] = cell.cases;
        else
            one["why"] = cell.why;
        json.push_back(std::move(one));
    }
    return json;
}

Json case_json(const CaseResult& result) {
    Json json{{"name", result.name}, {"tier", result.tier}, {"about", result.about}, {"command", result.command},
              {"parameters", result.parameters}, {"verdict", name(result.verdict)}, {"symmetry", result.symmetry}};
    json["checks"] = Json::array();
    for (const Row& row : result.rows) json["checks"].push_back(row_json(row));
    json["comparison"] = Json::array();
    for (const Comparison& line : compare_sides(result.rows)) json["comparison"].push_back(comparison_json(line));
    return json;
}

CaseResult case_of(const Json& json) {
    CaseResult result{json.at("name"), json.at("tier"), json.at("about"), json.at("command"), json.at("parameters"), {}, Verdict::info, json.at("symmetry")};
    for (const Json& row : json.at("checks")) result.rows.push_back(row_of(row));
    result.verdict = verdict_of(json.at("verdict"));
    return result;
}

Json note_json(const SolveNote& note) {
    return {{"solver", note.solver}, {"method", note.method}, {"cells", note.cells}, {"dofs", note.dofs}, {"iterations", note.iterations},
            {"relative_residual", number(note.residual)}, {"seconds", number(note.seconds)}, {"bytes", number(note.bytes)}};
}

SolveNote note_of(const Json& json) {
    return {json.at("solver"), json.at("method"), integer_of(json.at("cells")), integer_of(json.at("dofs")), static_cast<int>(integer_of(json.at("iterations"))), number_of(json.at("relative_residual")),
            number_of(json.at("seconds")), number_of(json.at("bytes"))};
}

}  // namespace cleave::validation
