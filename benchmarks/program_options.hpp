#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cleave::benchmarks {

enum class Level { quick, full };

struct ProgramOptions {
    std::filesystem::path out;       ///< JSON file; empty: none
    std::string filter = ".";        ///< regular expression over names
    std::filesystem::path baseline;  ///< JSON file of an earlier run to compare with; empty: none
    std::filesystem::path from;      ///< JSON file to compare instead of running; empty: run
    bool instructions = false;       ///< rows that count instructions (valgrind must be there)
    Level level = Level::quick;
    std::vector<std::string> rest;   ///< for Google Benchmark
    bool help = false;
    std::string help_text;
};

/// Throws InputError for an option that is misspelt, or a value that is not allowed.
ProgramOptions parse_options(int argc, char** argv);

}  // namespace cleave::benchmarks
