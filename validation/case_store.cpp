#include "validation/case_store.hpp"

#include "solver/input/file_io.hpp"
#include "validation/results_json.hpp"
#include "validation/runner.hpp"

#include <nlohmann/json.hpp>

namespace cleave::validation {

CaseStore::CaseStore(std::filesystem::path out, std::string level)
    : out_(std::move(out)), level_(std::move(level)), program_(content_hash(read_file("/proc/self/exe"))) {}

std::filesystem::path CaseStore::file(const Case& of) const { return out_ / "cases" / (artifact_folder(of.name) + ".json"); }

std::string CaseStore::fingerprint(const Case& of) const {
    std::string inputs = program_ + "\n" + level_ + "\n" + of.name + "\n" + of.text;
    if (of.shape)
        for (const std::filesystem::path& input : of.shape->input_files()) inputs.append("\n").append(content_hash(read_file(input)));
    return content_hash(inputs);
}

void CaseStore::save(const Case& of, const FinishedCase& finished) const {
    Json json{{"schema", "cleave.case/1"}, {"fingerprint", fingerprint(of)}, {"seconds", finished.seconds},
              {"result", case_json(finished.result)}, {"solves", Json::array()}};
    for (const SolveNote& note : finished.solves) json["solves"].push_back(note_json(note));
    write_file_atomic(file(of), json.dump(1) + "\n");
}

std::optional<FinishedCase> CaseStore::find(const Case& of) const try {
    if (!std::filesystem::exists(file(of))) return std::nullopt;
    const Json json = Json::parse(read_file(file(of)));
    if (json.at("schema") != "cleave.case/1" || json.at("fingerprint") != fingerprint(of)) return std::nullopt;
    FinishedCase finished{case_of(json.at("result")), json.at("seconds"), {}};
    for (const Json& note : json.at("solves")) finished.solves.push_back(note_of(note));
    for (const Row& row : finished.result.rows)
        for (const Artifact& artifact : row.artifacts)
            if (!std::filesystem::exists(out_ / artifact.file)) return std::nullopt;
    return finished;
} catch (const nlohmann::json::exception&) {
    return std::nullopt;  // not one of ours, or of another version: the case runs again
}

void CaseStore::remove(const Case& of) const { std::filesystem::remove(file(of)); }

}  // namespace cleave::validation
