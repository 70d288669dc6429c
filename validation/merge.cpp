#include "validation/merge.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/paths.hpp"
#include "validation/results_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace cleave::validation {

namespace {

namespace fs = std::filesystem;

/// An artifact is copied by its name: one that leads out of the folder would be read, and written, anywhere.
void require_artifacts_inside(const CaseResult& result, const fs::path& file) {
    for (const Row& row : result.rows)
        for (const Artifact& artifact : row.artifacts)
            if (leads_outside(artifact.file)) throw InputError(file.string(), "artifacts: " + artifact.file, "a path inside the results folder");
}

/// The case as results.json has it, with its place and costs from the store.
FinishedCase read_case(const fs::path& folder, const Json& json) {
    FinishedCase finished = read_finished_case(finished_case_file(folder, json.at("name")));
    finished.result = case_of(json);
    return finished;
}

/// One folder's results.json and the finished cases beside it.
MergedRun read_run(const fs::path& folder) {
    const fs::path file = folder / "results.json";
    MergedRun run;
    try {
        const Json results = Json::parse(read_file(file));
        if (results.at("schema") != "cleave.results/1") throw InputError(file.string(), "schema", "\"cleave.results/1\"");
        run.level = results.at("level");
        if (!results.at("cases").is_array()) throw InputError(file.string(), "cases", "an array [...]");
        for (const Json& json : results.at("cases")) run.cases.push_back(read_case(folder, json));
    } catch (const nlohmann::json::exception&) {
        throw InputError(file.string(), "", "a results.json of schema cleave.results/1");
    }
    for (const FinishedCase& finished : run.cases) require_artifacts_inside(finished.result, file);
    return run;
}

void copy_artifacts(const FinishedCase& finished, const fs::path& from, const fs::path& to) {
    if (fs::weakly_canonical(from) == fs::weakly_canonical(to)) return;
    for (const Row& row : finished.result.rows)
        for (const Artifact& artifact : row.artifacts) write_file_atomic(to / artifact.file, read_file(from / artifact.file));
}

}  // namespace

MergedRun merge_runs(const std::vector<fs::path>& folders, const fs::path& out) {
    MergedRun merged;
    std::map<std::string, fs::path> home;
    for (const fs::path& folder : folders) {
        const fs::path file = folder / "results.json";
        MergedRun run = read_run(folder);
        if (!merged.level.empty() && run.level != merged.level)
            throw InputError(file.string(), "level", fmt::format("{}, as in the other folders (not {})", merged.level, run.level));
        merged.level = run.level;
        for (FinishedCase& finished : run.cases) {
            merged.cases.push_back(std::move(finished));
            const std::string& name = merged.cases.back().result.name;
            if (const auto [other, fresh] = home.emplace(name, folder); !fresh)
                throw InputError(file.string(), name, fmt::format("each case once (it also stands in {})", other->second.string()));
        }
    }
    std::stable_sort(merged.cases.begin(), merged.cases.end(), [](const auto& a, const auto& b) { return a.position < b.position; });
    for (const FinishedCase& finished : merged.cases) copy_artifacts(finished, home.at(finished.result.name), out);
    return merged;
}

}  // namespace cleave::validation
