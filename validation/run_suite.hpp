#pragma once

#include "validation/case_store.hpp"

#include <functional>

namespace cleave::validation {

struct SuiteOptions {
    std::string level = "quick";
    std::filesystem::path out;
    int jobs = 1;        ///< processes
    bool reuse = false;  ///< cases that OUT/cases holds finished, from the same inputs and program, are not run again
    int threads = 0;     ///< threads of a process; 0: its share of the cores. The results do not depend on it, to the byte
};

/// Runs the cases and returns them in their order, whatever the number of processes; progress goes to stderr. `finished` is called in that
/// order, as soon as a case is known. Throws InputError, EnvironmentError; with several processes the line is printed already and
/// SuiteFailed carries the exit code.
std::vector<FinishedCase> run_suite(const std::vector<Case>& cases, const SuiteOptions& options,
                                    const std::function<void(std::size_t, FinishedCase&)>& finished);

struct SuiteFailed {
    int exit_code;
};

}  // namespace cleave::validation
