// What cleave validate reads of earlier runs: results.json, and the finished cases beside it.

#include "validation/merge.hpp"
#include "validation/results_json.hpp"
#include "validation/test/fuzz/results_seeds.hpp"
#include "validation/test/fuzz/target.hpp"

namespace cleave::fuzz {

namespace {

using validation::Json;

std::string stored_case() {
    const validation::FinishedCase finished = finished_case();
    return Json{{"schema", "cleave.case/1"}, {"fingerprint", ""}, {"position", finished.position}, {"seconds", finished.seconds},
                {"result", validation::case_json(finished.result)}, {"solves", {validation::note_json(finished.solves[0])}}}.dump(1);
}

void merge_and_compare(const std::string& bytes) {
    static const std::filesystem::path beside = input_file("cases/seed.json", stored_case());
    const std::filesystem::path file = input_file("results.json", bytes), folder = file.parent_path();
    const validation::MergedRun merged = validation::merge_runs({folder}, folder);
    std::vector<validation::CaseResult> cases;
    for (const validation::FinishedCase& finished : merged.cases) cases.push_back(finished.result);
    (void)validation::drift(cases, file.string());
    (void)validation::results_json(cases, merged.level);
    (void)validation::results_csv(cases);
    (void)validation::junit_xml(cases);
}

void read_stored(const std::string& bytes) { (void)validation::read_finished_case(input_file("stored.json", bytes)); }

}  // namespace

Target results_target() { return {"results", {results_seed()}, merge_and_compare}; }
Target stored_case_target() { return {"stored_case", {stored_case()}, read_stored}; }

}  // namespace cleave::fuzz
