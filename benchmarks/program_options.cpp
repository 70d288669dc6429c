#include "benchmarks/program_options.hpp"

#include "solver/input/input_error.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace cleave::benchmarks {

ProgramOptions parse_options(int argc, char** argv) {
    ProgramOptions options;
    std::string level = "quick", out;
    CLI::App app{"Benchmarks; ratios and work counts stand in the counters (see benchmarks/README.md)"};
    app.add_option("--out", out, "write Google Benchmark's JSON to FILE");
    app.add_option("--filter", options.filter, "regular expression: run the benchmarks whose name it matches");
    app.add_option("--level", level, "quick: small bodies; full: all")->check(CLI::IsMember({"quick", "full"}));
    app.allow_extras();
    app.footer("Options --benchmark_... are passed on to Google Benchmark.");
    options.help_text = app.help();
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        options.help = true;
        return options;
    } catch (const CLI::ParseError& error) {
        throw InputError("", "command line", std::string("[--filter RE] [--level quick|full] [--out FILE] (") + error.what() + ")");
    }
    options.out = out;
    options.level = level == "full" ? Level::full : Level::quick;
    options.rest = app.remaining();
    const auto stranger = std::find_if(options.rest.begin(), options.rest.end(),
                                       [](const std::string& text) { return !text.starts_with("--benchmark_"); });
    if (stranger != options.rest.end()) {
        throw InputError("", "command line", "[--filter RE] [--level quick|full] [--out FILE], not '" + *stranger + "'");
    }
    return options;
}

}  // namespace cleave::benchmarks
