#pragma once

#include "validation/case.hpp"
#include "validation/results.hpp"
#include "validation/solve_note.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cleave::validation {

/// What one finished case left: its rows, and what it cost.
struct FinishedCase {
    CaseResult result;
    double seconds = 0;
    std::vector<SolveNote> solves;
    std::size_t position = 0;  ///< among all cases of the run, before it was split into shards
};

/// Finished cases as files, OUT/cases/NAME.json, each written whole: what several processes of one run leave for their parent, and what a later
/// run takes up. A file counts only for the same case text, level, mesh files and program, byte for byte, and while its artifacts are there.
class CaseStore {
public:
    CaseStore(std::filesystem::path out, std::string level);
    void save(const Case& of, const FinishedCase& finished) const;
    std::optional<FinishedCase> find(const Case& of) const;
    void remove(const Case& of) const;

private:
    std::string fingerprint(const Case& of) const;

    std::filesystem::path out_;
    std::string level_, program_;
};

/// Reads one file of a store, whatever its fingerprint. Throws InputError where it is none.
FinishedCase read_finished_case(const std::filesystem::path& file);

/// The file of a case in the folder of a run.
std::filesystem::path finished_case_file(const std::filesystem::path& out, const std::string& case_name);

}  // namespace cleave::validation
