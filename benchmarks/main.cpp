#include "benchmarks/compare.hpp"
#include "benchmarks/json_reporter.hpp"
#include "benchmarks/program_options.hpp"
#include "benchmarks/rows.hpp"
#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

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

nlohmann::json read_run(const std::filesystem::path& path) {
    nlohmann::json run = nlohmann::json::parse(read_file(path), nullptr, false);
    if (run.is_discarded() || !run.contains("benchmarks")) throw InputError(path.string(), "", "JSON that `cleave bench --out` wrote");
    return run;
}

/// Runs what the filter names; the run's JSON.
std::string run_rows(const ProgramOptions& options, char* program) {
    initialize(options, program);
    add_context(options.level == Level::full ? "full" : "quick");
    register_all(options.level, options.instructions);
    JsonReporter reporter;
    if (benchmark::RunSpecifiedBenchmarks(&reporter) == 0) {
        throw InputError("", "--filter", fmt::format("a regular expression that matches a benchmark ('{}' matches none)", options.filter));
    }
    benchmark::Shutdown();
    return reporter.json();
}

int body(int argc, char** argv) {
    const ProgramOptions options = parse_options(argc, argv);
    if (options.help) {
        fmt::print("{}", options.help_text);
        return 0;
    }
    nlohmann::json baseline;
    if (!options.baseline.empty()) baseline = read_run(options.baseline);  // before the run: a wrong name must not cost minutes
    if (!options.from.empty()) {
        const Comparison comparison = compare(baseline, read_run(options.from));
        fmt::print("{}", table(comparison));
        return exit_code(comparison);
    }
    const std::string run = run_rows(options, argv[0]);
    if (!options.out.empty()) write_file_atomic(options.out, run);
    if (options.baseline.empty()) return 0;
    const Comparison comparison = compare(baseline, nlohmann::json::parse(run));
    fmt::print("\n{}", table(comparison));
    return exit_code(comparison);
}

}  // namespace

int main(int argc, char** argv) { return run_program("cleave-bench", body, argc, argv); }
