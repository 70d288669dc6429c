#pragma once

#include "solver/input/input_error.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>

namespace cleave {

/// Parses a program's command line. False where --help was asked for: it is printed, nothing else is left to do.
/// Throws InputError: `key` (the program, or "command line"), `expected`, and what CLI11 found.
inline bool parse_command_line(CLI::App& app, int argc, char** argv, const std::string& key, const std::string& expected) {
    try {
        app.parse(argc, argv);
        return true;
    } catch (const CLI::CallForHelp&) {
        std::fputs(app.help().c_str(), stdout);
        return false;
    } catch (const CLI::ParseError& error) {
        throw InputError("", key, expected + " (" + error.what() + ")");
    }
}

}  // namespace cleave
