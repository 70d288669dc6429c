#include "validation/results_json.hpp"

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
    if (band.side != Side::either) json["side"] = name(band.side);
    return json;
}

Json resolution_json(const Resolution& resolution) {
    Json json{{"size", number(resolution.size)}, {"unit", "m"}};
    if (resolution.particles > 0) json["particles"] = resolution.particles;
    if (resolution.dofs > 0) json["dofs"] = resolution.dofs;
    return json;
}

double error_of(const Row& row) { return row.relative ? row.measurement.relative_error : row.measurement.absolute_error; }

Json row_json(const Row& row) {
    Json json{{"case", row.case_name}, {"tier", row.tier}, {"quantity", row.quantity}, {"component", row.component}, {"unit", row.unit},
              {"place", row.place}, {"solver", row.solver}, {"resolution", resolution_json(row.resolution)},
              {"value", number(row.measurement.value)}, {"reference", number(row.measurement.reference)},
              {"reference_source", row.reference_source}, {"error", number(error_of(row))},
              {"error_kind", row.relative ? "relative" : "absolute"}, {"band", band_json(row.band)}, {"basis", row.basis},
              {"order", number(row.measurement.order)}, {"must_fail", row.must_fail}, {"verdict", name(row.verdict)}};
    json["ladder"] = Json::array();
    for (const LadderStep& step : row.ladder) {
        Json entry = resolution_json(step.resolution);
        entry["error"] = number(step.error);
        json["ladder"].push_back(entry);
    }
    json["artifacts"] = Json::array();
    for (const Artifact& a : row.artifacts) json["artifacts"].push_back({{"file", a.file}, {"title", a.title}, {"x", a.x}, {"y", a.y}});
    return json;
}

double number_of(const Json& json) { return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>(); }

std::optional<double> optional_of(const Json& json) { return json.is_null() ? std::nullopt : std::optional<double>(json.get<double>()); }

Band band_of(const Json& json) {
    Band band;
    if (json.is_null()) return band;
    if (json.contains("relative")) band.relative = json["relative"].get<double>();
    if (json.contains("absolute")) band.absolute = json["absolute"].get<double>();
    if (json.contains("order_at_least")) band.order_at_least = json["order_at_least"].get<double>();
    if (json.contains("side")) band.side = json["side"] == "below" ? Side::below : Side::above;
    return band;
}

Resolution resolution_of(const Json& json) { return {number_of(json.at("size")), json.value("particles", 0L), json.value("dofs", 0L)}; }

Verdict verdict_of(const std::string& text) { return text == "pass" ? Verdict::pass : text == "fail" ? Verdict::fail : Verdict::info; }

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
    for (const Json& step : json.at("ladder")) row.ladder.push_back({resolution_of(step), number_of(step.at("error"))});
    for (const Json& a : json.at("artifacts")) row.artifacts.push_back({a.at("file"), a.at("title"), a.at("x"), a.at("y")});
    row.verdict = verdict_of(json.at("verdict"));
    return row;
}

}  // namespace

Json case_json(const CaseResult& result) {
    Json json{{"name", result.name}, {"tier", result.tier}, {"about", result.about}, {"command", result.command},
              {"parameters", result.parameters}, {"verdict", name(result.verdict)}};
    json["checks"] = Json::array();
    for (const Row& row : result.rows) json["checks"].push_back(row_json(row));
    return json;
}

CaseResult case_of(const Json& json) {
    CaseResult result{json.at("name"), json.at("tier"), json.at("about"), json.at("command"), json.at("parameters"), {}, Verdict::info};
    for (const Json& row : json.at("checks")) result.rows.push_back(row_of(row));
    result.verdict = verdict_of(json.at("verdict"));
    return result;
}

Json note_json(const SolveNote& note) {
    return {{"solver", note.solver}, {"method", note.method}, {"cells", note.cells}, {"dofs", note.dofs}, {"iterations", note.iterations},
            {"relative_residual", number(note.residual)}, {"seconds", number(note.seconds)}, {"bytes", number(note.bytes)}};
}

SolveNote note_of(const Json& json) {
    return {json.at("solver"), json.at("method"), json.at("cells"), json.at("dofs"), json.at("iterations"), number_of(json.at("relative_residual")),
            number_of(json.at("seconds")), number_of(json.at("bytes"))};
}

}  // namespace cleave::validation
