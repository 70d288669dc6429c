#include "validation/results.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "validation/results_json.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cleave::validation {

namespace {

double error_of(const Row& row) { return row.relative ? row.measurement.relative_error : row.measurement.absolute_error; }

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string csv_number(const std::optional<double>& value) { return value && std::isfinite(*value) ? fmt::format("{}", *value) : ""; }

std::string xml(const std::string& text) {
    std::string escaped;
    for (const char c : text) switch (c) {
            case '<': escaped += "&lt;"; break;
            case '>': escaped += "&gt;"; break;
            case '&': escaped += "&amp;"; break;
            case '"': escaped += "&quot;"; break;
            default: escaped += c;
        }
    return escaped;
}

std::string test_name(const Row& row) {
    return fmt::format("{}{}{} of {}, {}{}", row.quantity, row.component.empty() ? "" : " ", row.component, row.solver, row.place,
                       row.must_fail ? " (must fail)" : "");
}

std::string band_text(const Band& band) {
    std::string text;
    const auto add = [&](const char* word, const std::optional<double>& limit) {
        if (limit) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", word, *limit);
    };
    add("relative", band.relative);
    add("absolute", band.absolute);
    add("order at least", band.order_at_least);
    if (band.side != BandSide::either) text += fmt::format("{}{} the reference", text.empty() ? "" : ", ", name(band.side));
    return text;
}

/// Identity of a row across runs.
std::string key(const Json& check) {
    return fmt::format("{} | {} {} | {} | {} | {}{}", check.value("case", ""), check.value("quantity", ""), check.value("component", ""),
                       check.value("solver", ""), check.value("place", ""), check.value("reference_source", ""),
                       check.value("must_fail", false) ? " (must fail)" : "");
}

std::map<std::string, std::pair<double, std::string>> rows_by_key(const Json& results) {
    std::map<std::string, std::pair<double, std::string>> rows;
    for (const Json& of : results.at("cases"))
        for (const Json& check : of.at("checks")) {
            const double error = check.at("error").is_null() ? std::nan("") : check.at("error").get<double>();
            rows[key(check)] = {error, check.at("verdict").get<std::string>()};
        }
    return rows;
}

}  // namespace

std::string place_text(const Row& row) { return row.detail.empty() ? row.place : fmt::format("{} ({})", row.place, row.detail); }

Counts count(const std::vector<CaseResult>& cases) {
    Counts counts;
    for (const CaseResult& result : cases)
        for (const Row& row : result.rows)
            ++(row.verdict == Verdict::pass ? counts.pass : row.verdict == Verdict::fail ? counts.fail : counts.info);
    return counts;
}

std::string results_json(const std::vector<CaseResult>& cases, const std::string& level) {
    const Counts counts = count(cases);
    Json json{{"schema", "cleave.results/1"}, {"level", level},
              {"counts", {{"pass", counts.pass}, {"fail", counts.fail}, {"info", counts.info}}}};
    json["headline"] = headline_json(cases);
    json["coverage"] = coverage_json(cases);
    json["cases"] = Json::array();
    for (const CaseResult& result : cases) json["cases"].push_back(case_json(result));
    return json.dump(1) + "\n";
}

std::string results_csv(const std::vector<CaseResult>& cases) {
    std::string text = "case,tier,quantity,component,unit,place,solver,size_m,particles,dofs,value,reference,reference_source,error,error_kind,band,order,must_fail,verdict\n";
    for (const CaseResult& result : cases)
        for (const Row& row : result.rows)
            text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_cell(row.case_name), row.tier, row.quantity,
                                row.component, row.unit, csv_cell(place_text(row)), row.solver, row.resolution.size, row.resolution.particles,
                                row.resolution.dofs, csv_number(row.measurement.value), csv_number(row.measurement.reference),
                                csv_cell(row.reference_source), csv_number(error_of(row)), row.relative ? "relative" : "absolute",
                                csv_cell(band_text(row.band)), csv_number(row.measurement.order), row.must_fail ? 1 : 0, name(row.verdict));
    return text;
}

std::string junit_xml(const std::vector<CaseResult>& cases) {
    const Counts counts = count(cases);
    std::string text = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"{}\" failures=\"{}\">\n",
                                   counts.pass + counts.fail, counts.fail);
    for (const CaseResult& result : cases) {
        const Counts own = count({result});
        text += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n", xml(result.name), own.pass + own.fail, own.fail);
        for (const Row& row : result.rows) {
            if (row.verdict == Verdict::info) continue;
            text += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", xml(row.case_name), xml(test_name(row)));
            if (row.verdict == Verdict::pass)
                text += "/>\n";
            else
                text += fmt::format(">\n      <failure message=\"error {}, order {}, band {}{}\"/>\n    </testcase>\n", csv_number(error_of(row)),
                                    csv_number(row.measurement.order), xml(band_text(row.band)), row.detail.empty() ? "" : "; " + xml(row.detail));
        }
        text += "  </testsuite>\n";
    }
    return text + "</testsuites>\n";
}

std::string drift(const std::vector<CaseResult>& cases, const std::string& old_file) {
    std::map<std::string, std::pair<double, std::string>> before;
    try {
        const Json old = Json::parse(read_file(old_file));
        if (old.at("schema") != "cleave.results/1") throw InputError(old_file, "schema", "cleave.results/1");
        before = rows_by_key(old);
    } catch (const nlohmann::json::exception&) {
        throw InputError(old_file, "", "a results.json of schema cleave.results/1");
    }
    const auto now = rows_by_key(Json::parse(results_json(cases, "")));
    std::string text;
    int same = 0;
    for (const auto& [row, value] : now) {
        const auto found = before.find(row);
        if (found == before.end())
            text += fmt::format("new      {}: error {:.6g}, {}\n", row, value.first, value.second);
        else if (found->second.first == value.first || (std::isnan(found->second.first) && std::isnan(value.first)))
            ++same;
        else
            text += fmt::format("drifted  {}: error {:.6g} -> {:.6g}, {} -> {}\n", row, found->second.first, value.first, found->second.second, value.second);
    }
    for (const auto& [row, value] : before)
        if (!now.count(row)) text += fmt::format("vanished {}\n", row);
    return text + fmt::format("{} rows unchanged\n", same);
}

}  // namespace cleave::validation
