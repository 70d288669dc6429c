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
    CaseResult result;  ///< without the command, which depends on how it was called
    double seconds = 0;
    std::vector<SolveNote> solves;
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
    std::filesystem::path file(const Case& of) const;
    std::string fingerprint(const Case& of) const;

    std::filesystem::path out_;
    std::string level_, program_;
};

}  // namespace cleave::validation
