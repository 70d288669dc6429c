#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace cleave::reports {

/// What one results folder holds, as it was written: nothing is judged or recomputed here.
struct ReportSource {
    std::string folder;            ///< as named on the command line
    nlohmann::json results;        ///< results.json, schema cleave.results/1, checked by check_results
    nlohmann::json bench;          ///< bench.json (Google Benchmark); null where the folder has none
    nlohmann::json timings;        ///< timings.json; null where the folder has none
    nlohmann::json provenance;     ///< provenance.json; null where the folder has none
    nlohmann::json artifacts;      ///< object: artifact file -> read_artifact's table or note
    nlohmann::json fields;         ///< object: artifact file -> stress field or note (read_fields)
    nlohmann::json scenes;         ///< array: read_scenes
};

struct Report {
    std::vector<ReportSource> sources;  ///< in the order of the command line
    nlohmann::json history;             ///< read_history; null without earlier runs
};

/// Reads results.json and its companions from each folder. Throws InputError where results.json is missing, broken or of another
/// schema, where a companion is not JSON, where an artifact points outside its folder, or where two folders hold the same case
/// (level, name and parameters). Missing companions and artifacts are no error: the page says that they are missing.
Report load_report(const std::vector<std::filesystem::path>& folders);

}  // namespace cleave::reports
