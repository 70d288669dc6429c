#include "validation/case_store.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/paths.hpp"
#include "validation/results_json.hpp"
#include "validation/runner.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cleave::validation {

namespace {

constexpr const char* schema = "cleave.case/1";

FinishedCase finished_of(const Json& json) {
    FinishedCase finished{case_of(json.at("result")), json.at("seconds"), {}, json.at("position").get_ref<const Json::number_unsigned_t&>()};
    for (const Json& note : json.at("solves")) finished.solves.push_back(note_of(note));
    return finished;
}

}  // namespace

std::filesystem::path finished_case_file(const std::filesystem::path& out, const std::string& case_name) {
    return out / "cases" / (artifact_folder(case_name) + ".json");
}

FinishedCase read_finished_case(const std::filesystem::path& file) try {
    const Json json = Json::parse(read_file(file));
    if (json.at("schema") != schema) throw InputError(file.string(), "schema", fmt::format("\"{}\"", schema));
    return finished_of(json);
} catch (const nlohmann::json::exception&) {
    throw InputError(file.string(), "", "a finished case, as cleave validate writes it");
}

CaseStore::CaseStore(std::filesystem::path out, std::string level)
    : out_(std::move(out)), level_(std::move(level)), program_(content_hash(read_file("/proc/self/exe"))) {}

std::string CaseStore::fingerprint(const Case& of) const {
    std::string inputs = program_ + "\n" + level_ + "\n" + of.name + "\n" + of.text;
    std::vector<std::filesystem::path> files;
    if (of.shape) files = of.shape->input_files();
    if (of.study) files = of.study->input_files();
    for (const std::filesystem::path& input : files) inputs.append("\n").append(content_hash(read_file(input)));
    return content_hash(inputs);
}

void CaseStore::save(const Case& of, const FinishedCase& finished) const {
    Json json{{"schema", schema}, {"fingerprint", fingerprint(of)}, {"position", of.position}, {"seconds", finished.seconds},
              {"result", case_json(finished.result)}, {"solves", Json::array()}};
    for (const SolveNote& note : finished.solves) json["solves"].push_back(note_json(note));
    write_file_atomic(finished_case_file(out_, of.name), json.dump(1) + "\n");
}

std::optional<FinishedCase> CaseStore::find(const Case& of) const try {
    const std::filesystem::path file = finished_case_file(out_, of.name);
    if (!is_there(file)) return std::nullopt;
    Json json = Json::parse(read_file(file));
    if (json.at("schema") != schema || json.at("fingerprint") != fingerprint(of)) return std::nullopt;
    if (json.at("position") != of.position) {  // of a run over other cases
        json["position"] = of.position;
        write_file_atomic(file, json.dump(1) + "\n");
    }
    FinishedCase finished = finished_of(json);
    finished.result.command = of.command;
    for (const Row& row : finished.result.rows)
        for (const Artifact& artifact : row.artifacts)
            if (!is_there(out_ / artifact.file)) return std::nullopt;
    return finished;
} catch (const nlohmann::json::exception&) {
    return std::nullopt;  // not one of ours, or of another version: the case runs again
}

void CaseStore::remove(const Case& of) const { std::filesystem::remove(finished_case_file(out_, of.name)); }

}  // namespace cleave::validation
