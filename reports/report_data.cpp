#include "reports/report_data.hpp"

#include "reports/artifact_table.hpp"
#include "reports/field_files.hpp"
#include "reports/json_file.hpp"
#include "reports/results_check.hpp"
#include "reports/scene_files.hpp"
#include "solver/input/input_error.hpp"

#include <map>

namespace cleave::reports {

using nlohmann::json;
using std::filesystem::path;

namespace {

json read_artifacts(const path& folder, const json& results, const std::string& results_file) {
    json tables = json::object();
    for (const json& entry : results["cases"]) {
        for (const json& row : entry["checks"]) {
            if (!row.contains("artifacts") || row["artifacts"].is_null()) continue;
            for (const json& artifact : row["artifacts"]) {
                const std::string file = artifact["file"];
                if (!is_stress_field(file) && !tables.contains(file)) tables[file] = read_artifact(folder, file, results_file);
            }
        }
    }
    return tables;
}

ReportSource read_source(const path& folder) {
    const path file = folder / "results.json";
    ReportSource source;
    source.folder = folder.string();
    source.results = read_json(file);
    check_results(source.results, file.string());
    source.bench = read_companion(folder / "bench.json");
    source.timings = read_companion(folder / "timings.json");
    source.provenance = read_companion(folder / "provenance.json");
    source.artifacts = read_artifacts(folder, source.results, file.string());
    source.fields = read_fields(folder, source.results, file.string());
    source.scenes = read_scenes(folder);
    return source;
}

std::string identity(const json& results, const json& entry) {
    return json::array({results.value("level", json()), entry["name"], entry.value("parameters", json::object())}).dump();
}

/// A case that two folders hold would be counted twice, and nobody could say which of the two is meant.
void reject_repeated_cases(const Report& report) {
    std::map<std::string, std::string> seen;
    for (const ReportSource& source : report.sources) {
        for (const json& entry : source.results["cases"]) {
            const auto [it, inserted] = seen.emplace(identity(source.results, entry), source.folder);
            if (inserted) continue;
            throw InputError((path(source.folder) / "results.json").string(), entry["name"].get<std::string>(),
                             "each case once (it also stands in " + it->second + ")");
        }
    }
}

}  // namespace

Report load_report(const std::vector<path>& folders) {
    Report report;
    for (const path& folder : folders) report.sources.push_back(read_source(folder));
    reject_repeated_cases(report);
    return report;
}

}  // namespace cleave::reports
