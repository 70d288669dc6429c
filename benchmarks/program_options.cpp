#include "benchmarks/program_options.hpp"

#include "solver/input/input_error.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace cleave::benchmarks {

ProgramOptions parse_options(int argc, char** argv) {
    ProgramOptions options;
    constexpr const char* usage = "[--filter RE] [--level quick|full] [--out FILE] [--instructions] [--compare BASELINE.json [--from RUN.json]]";
    std::string level = "quick", out, baseline, from;
    CLI::App app{"Benchmarks; ratios and work counts stand in the counters (see benchmarks/README.md)"};
    app.add_option("--out", out, "write Google Benchmark's JSON to FILE");
    app.add_option("--filter", options.filter, "regular expression: run the benchmarks whose name it matches");
    app.add_option("--level", level, "quick: small bodies; full: all")->check(CLI::IsMember({"quick", "full"}));
    CLI::Option* compare = app.add_option("--compare", baseline, "judge ratios and instruction counts against an earlier run's JSON");
    app.add_option("--from", from, "with --compare: judge this run's JSON instead of running")->needs(compare);
    app.add_flag("--instructions", options.instructions, "also count instructions, by valgrind");
    app.allow_extras();
    app.footer("Options --benchmark_... are passed on to Google Benchmark.");
    options.help_text = app.help();
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        options.help = true;
        return options;
    } catch (const CLI::ParseError& error) {
        throw InputError("", "command line", std::string(usage) + " (" + error.what() + ")");
    }
    options.out = out;
    options.baseline = baseline;
    options.from = from;
    options.level = level == "full" ? Level::full : Level::quick;
    options.rest = app.remaining();
    const auto stranger = std::find_if(options.rest.begin(), options.rest.end(),
                                       [](const std::string& text) { return !text.starts_with("--benchmark_"); });
    if (stranger != options.rest.end()) {
        throw InputError("", "command line", std::string(usage) + ", not '" + *stranger + "'");
    }
    return options;
}

}  // namespace cleave::benchmarks
