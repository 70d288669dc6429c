#pragma once

#include <stdexcept>
#include <string>

namespace cleave {

/// Something the user can mend: a file, key or value. Programs print what() as one line and exit with code 2.
/// what() reads "FILE:LINE: KEY: expected EXPECTED"; empty parts are left out.
class InputError : public std::runtime_error {
public:
    InputError(std::string file, int line, std::string key, std::string expected);
    /// Without a line, where the input has none (a binary file, a command line).
    InputError(std::string file, std::string key, std::string expected);

    const std::string& file() const { return file_; }
    int line() const { return line_; }
    const std::string& key() const { return key_; }
    const std::string& expected() const { return expected_; }

private:
    std::string file_;
    int line_ = 0;
    std::string key_;
    std::string expected_;
};

/// The environment is at fault (missing program, full disk, no rights). Exit code 3.
class EnvironmentError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Exit codes shared by every program (see README).
enum class ExitCode : int { ok = 0, missed = 1, input = 2, environment = 3, bug = 4 };

/// Runs a program's body and turns its exceptions into one line on stderr and the exit code:
/// InputError -> 2, EnvironmentError -> 3, anything else -> 4.
int run_program(const char* program, int (*body)(int, char**), int argc, char** argv);

}  // namespace cleave
