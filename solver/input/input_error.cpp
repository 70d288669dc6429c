#include "solver/input/input_error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <new>

namespace cleave {

namespace {
std::string message(const std::string& file, int line, const std::string& key, const std::string& expected) {
    std::string text = file;
    if (line > 0) text += fmt::format(":{}", line);
    if (!text.empty()) text += ": ";
    if (!key.empty()) text += key + ": ";
    return text + "expected " + expected;
}

int report(const char* program, const char* kind, const char* what, ExitCode code) {
    std::fprintf(stderr, "%s: %s%s\n", program, kind, what);
    return static_cast<int>(code);
}
}  // namespace

InputError::InputError(std::string file, int line, std::string key, std::string expected)
    : std::runtime_error(message(file, line, key, expected)),
      file_(std::move(file)), line_(line), key_(std::move(key)), expected_(std::move(expected)) {}

InputError::InputError(std::string file, std::string key, std::string expected)
    : InputError(std::move(file), 0, std::move(key), std::move(expected)) {}

int run_program(const char* program, int (*body)(int, char**), int argc, char** argv) {
    try {
        return body(argc, argv);
    } catch (const InputError& error) {
        return report(program, "", error.what(), ExitCode::input);
    } catch (const EnvironmentError& error) {
        return report(program, "", error.what(), ExitCode::environment);
    } catch (const std::bad_alloc&) {
        return report(program, "", "not enough memory", ExitCode::environment);
    } catch (const std::exception& error) {
        return report(program, "internal error: ", error.what(), ExitCode::bug);
    }
}

}  // namespace cleave
