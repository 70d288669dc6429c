#include "benchmarks/engine_bench.hpp"
#include "benchmarks/instructions.hpp"
#include "benchmarks/rows.hpp"
#include "benchmarks/timing.hpp"
#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace cleave::benchmarks {

double counted_instructions(const std::string& callgrind_output) {
    std::istringstream lines(callgrind_output);
    for (std::string line; std::getline(lines, line);) {
        for (const char* head : {"totals: ", "summary: "}) {
            if (line.starts_with(head)) return std::strtod(line.c_str() + std::string(head).size(), nullptr);
        }
    }
    throw EnvironmentError("callgrind's output has no total");
}

namespace {

struct CountedWork {
    double instructions, children;
};

/// A folder of this process alone, removed with it.
struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / fmt::format("cleave_instructions_{}", ::getpid());
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
};

/// Runs the work under valgrind. Throws EnvironmentError where there is none.
CountedWork count_instructions(int cells) {
    const Folder folder;
    const std::filesystem::path out = folder.path / "callgrind", children = folder.path / "children";
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "cleave-instruction-work";
    const std::string command = fmt::format("valgrind --tool=callgrind --collect-atstart=no --toggle-collect=cleave_counted_work "
                                            "--callgrind-out-file='{}' '{}' {} >'{}' 2>/dev/null",
                                            out.string(), program.string(), cells, children.string());
    if (std::system(command.c_str()) != 0) throw EnvironmentError("valgrind --tool=callgrind could not run (Debian package valgrind)");
    return {counted_instructions(read_file(out)), std::strtod(read_file(children).c_str(), nullptr)};
}

void instructions(benchmark::State& state, LazyCase& source, int cells) {
    const EngineBench bench(source.get());
    CountedWork counted{};
    for (auto _ : state) state.SetIterationTime(wall_seconds_of([&] { counted = count_instructions(cells); }));
    count_work(state, bench);
    state.counters["children"] = counted.children;
    state.counters["instructions_per_child"] = counted.instructions / counted.children;
}

}  // namespace

void register_instructions(Bodies& bodies) {
    for (const auto& [name, cells] : {std::pair("cube_6k", 10), std::pair("cube_83k", 24)}) {
        const auto body = bodies.cube(cells);
        add_row(std::string("subdivision/instructions/") + name, [=](benchmark::State& state) { instructions(state, *body, cells); });
    }
}

}  // namespace cleave::benchmarks
