// One bad input: the files, the call, and what the user must be told. The tables stand in bad_*_test.cpp.
#pragma once

#include "solver/input/test/scratch_folder.hpp"

#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace cleave::robustness {

/// A call of one of the programs in a folder that holds nothing but `files`.
struct BadInput {
    std::string name;                          ///< letters, digits, underscores
    std::string command;                       ///< validate, simulate, mesh, material or report, and its arguments; {} is the folder
    std::map<std::string, std::string> files;  ///< name, bytes
    std::vector<std::string> told;             ///< what the one line must contain: file, key, what was expected
    int exit_code = 2;
    std::string before{};                      ///< shell text put before the command (`ulimit -f 4;`)
};

/// Google Test prints the name instead of the bytes.
inline void PrintTo(const BadInput& input, std::ostream* out) { *out << input.name; }

/// `text` with `from`, which must be in it exactly once, replaced. @throws std::logic_error
std::string changed(const std::string& text, const std::string& from, const std::string& to);

/// Runs it within one minute and 6 GB of address space; returns what is wrong, empty where nothing is: another exit code, a signal, more or
/// less than one line on stderr, a missing part of `told`, anything on stdout, a file made, changed or removed.
std::string complaint(const BadInput& input);

}  // namespace cleave::robustness
