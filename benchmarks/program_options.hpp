#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cleave::benchmarks {

enum class Level { quick, full };

struct ProgramOptions {
    std::filesystem::path out;       ///< JSON file; empty: none
    std::string filter = ".";        ///< regular expression over names
    Level level = Level::quick;
    std::vector<std::string> rest;   ///< for Google Benchmark
    bool help = false;
    std::string help_text;
};

/// Throws InputError for an option that is misspelt, or a value that is not allowed.
ProgramOptions parse_options(int argc, char** argv);

}  // namespace cleave::benchmarks
