#include "benchmarks/json_reporter.hpp"
#include "benchmarks/program_options.hpp"
#include "benchmarks/subdivision_benchmarks.hpp"
#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace {

using namespace cleave;
using namespace cleave::benchmarks;

/// Hands the remaining options to Google Benchmark. Throws InputError for one it does not know.
void initialize(const ProgramOptions& options, char* program) {
    std::vector<std::string> words = options.rest;
    words.push_back("--benchmark_filter=" + options.filter);
    std::vector<char*> argv{program};
    for (std::string& word : words) argv.push_back(word.data());
    int argc = static_cast<int>(argv.size());
    benchmark::Initialize(&argc, argv.data());
    if (argc > 1) throw InputError("", "command line", fmt::format("an option of Google Benchmark, not '{}'", argv[1]));
}

int body(int argc, char** argv) {
    const ProgramOptions options = parse_options(argc, argv);
    if (options.help) {
        fmt::print("{}", options.help_text);
        return 0;
    }
    initialize(options, argv[0]);
    add_context(options.level == Level::full ? "full" : "quick");
    register_subdivision(options.level);
    JsonReporter reporter;
    if (benchmark::RunSpecifiedBenchmarks(&reporter) == 0) {
        throw InputError("", "--filter", fmt::format("a regular expression that matches a benchmark ('{}' matches none)", options.filter));
    }
    if (!options.out.empty()) write_file_atomic(options.out, reporter.json());
    benchmark::Shutdown();
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return run_program("cleave-bench", body, argc, argv); }
