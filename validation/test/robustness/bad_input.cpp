#include "validation/test/robustness/bad_input.hpp"

#include "solver/input/file_io.hpp"

#include <fmt/format.h>

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace cleave::robustness {

namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        all[fs::relative(entry.path(), folder).string()] = entry.is_regular_file() ? read_file(entry.path()) : "(folder)";
    return all;
}

std::string program_of(const std::string& verb) {
    const std::map<std::string, std::string> programs{{"validate", CLEAVE_VALIDATE_PROGRAM}, {"simulate", CLEAVE_SIMULATE_PROGRAM},
                                                      {"mesh", CLEAVE_MESH_PROGRAM}, {"material", CLEAVE_MATERIAL_PROGRAM},
                                                      {"report", CLEAVE_REPORT_PROGRAM}};
    return programs.at(verb);
}

std::string shell_line(const BadInput& input, const std::string& folder, const std::string& streams) {
    std::string arguments = input.command;
    for (std::size_t at; (at = arguments.find("{}")) != std::string::npos;) arguments.replace(at, 2, folder);
    const std::size_t space = arguments.find(' ');
    return fmt::format("cd '{}' && ulimit -v 6000000 && {} timeout -s KILL 60 {}{} >'{}/stdout' 2>'{}/stderr'", folder, input.before,
                       program_of(arguments.substr(0, space)), space == std::string::npos ? "" : arguments.substr(space), streams, streams);
}

std::string difference(const std::map<std::string, std::string>& before, const std::map<std::string, std::string>& after) {
    std::string text;
    for (const auto& [name, bytes] : after) {
        if (name == "out" || name.starts_with("out/meshes")) continue;  // a whole mesh is kept for the next run
        if (!before.count(name)) text += "; it left " + name;
        else if (before.at(name) != bytes) text += "; it changed " + name;
    }
    for (const auto& [name, bytes] : before)
        if (!after.count(name)) text += "; it removed " + name;
    return text;
}

}  // namespace

std::string changed(const std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos || text.find(from, at + 1) != std::string::npos) throw std::logic_error("expected exactly one '" + from + "'");
    return std::string(text).replace(at, from.size(), to);
}

std::string complaint(const BadInput& input) {
    const ScratchFolder folder, streams;
    for (const auto& [name, bytes] : input.files) write_file_atomic(folder / name, bytes);
    const auto before = contents(folder);
    const int status = std::system(shell_line(input, folder.path().string(), streams.path().string()).c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    const std::string out = read_file(streams / "stdout"), error = read_file(streams / "stderr");

    std::string text;
    if (code != input.exit_code) text += fmt::format("; exit code {} instead of {}", code, input.exit_code);
    const auto lines = std::count(error.begin(), error.end(), '\n');
    if (lines != 1) text += fmt::format("; {} lines on stderr", lines);
    for (const std::string& part : input.told)
        if (error.find(part) == std::string::npos) text += fmt::format("; no '{}'", part);
    if (!out.empty()) text += "; something on stdout";
    text += difference(before, contents(folder));
    return text.empty() ? text : fmt::format("{}\n  stderr: {}", text.substr(2), error.substr(0, 600));
}

}  // namespace cleave::robustness
