// cleave-validate: runs cases, compares particles, finite elements and mathematics, writes results.

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "validation/runner.hpp"
#include "validation/timings.hpp"
#include "validation/suite.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace cleave::validation {
namespace {

struct Arguments {
    std::vector<std::string> names, sets;
    std::string level = "quick", ladder, out = "out/validate", shard, compare;
    bool list = false;
};

Overrides overrides_of(const Arguments& arguments) {
    Overrides overrides;
    overrides.ladder = arguments.ladder;
    for (const std::string& text : arguments.sets) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0) throw InputError("", "--set", fmt::format("KEY=VALUE (not '{}')", text));
        overrides.values.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
    return overrides;
}

/// Everything is read before anything runs: a mistake in the last file costs no computing.
std::vector<Case> read_all(const Arguments& arguments) {
    std::vector<Case> cases;
    for (const std::filesystem::path& file : select_files(arguments.names))
        for (Case& one : read_cases(file.string(), overrides_of(arguments))) cases.push_back(std::move(one));
    for (std::size_t i = 0; i < cases.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (cases[i].name == cases[j].name) throw InputError(cases[i].file, "name", fmt::format("a name of its own ('{}' is also in {})", cases[i].name, cases[j].file));
    return arguments.shard.empty() ? cases : shard(cases, arguments.shard);
}

std::string command_of(const Case& one, const Arguments& arguments) {
    std::string command = "cleave validate " + std::filesystem::path(one.file).stem().string();
    if (one.file.find(CLEAVE_CASE_FOLDER) != 0) command = "cleave validate " + std::filesystem::path(one.file).filename().string();
    for (const std::string& text : arguments.sets) command += fmt::format(" --set '{}'", text);
    if (!arguments.ladder.empty()) command += " --ladder " + arguments.ladder;
    return command + " --level " + arguments.level;
}

void print(const CaseResult& result) {
    fmt::print("{:4}  {}\n", name(result.verdict), result.name);
    for (const Row& row : result.rows) {
        const double error = row.relative ? row.measurement.relative_error : row.measurement.absolute_error;
        std::string text = fmt::format("  {:4}  {:14} {:12} {:3} {}", name(row.verdict), row.solver, row.quantity, row.component, row.place);
        if (row.measurement.value) text += fmt::format("  {:.6g} {}", *row.measurement.value, row.unit);
        if (row.measurement.reference) text += fmt::format(" against {:.6g}, error {:.3g}", *row.measurement.reference, error);
        if (row.measurement.order) text += fmt::format(", order {:.2f}", *row.measurement.order);
        fmt::print("{}{}\n", text, row.must_fail ? " (must fail)" : "");
    }
    std::fflush(stdout);
}

/// A bar with the remaining time on a terminal, a plain line elsewhere; on stderr, so that stdout holds results only.
class Progress {
public:
    explicit Progress(std::size_t total) : total_(total), terminal_(isatty(STDERR_FILENO) != 0) {}
    void step(const std::string& what) {
        const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        ++done_;
        const double left = elapsed / static_cast<double>(done_) * static_cast<double>(total_ - std::min(done_, total_));
        if (terminal_) {
            const std::size_t filled = 30 * std::min(done_, total_) / total_;
            fmt::print(stderr, "\r\033[K[{:-<30}] {:.0f} s left  {}", std::string(filled, '#'), left, what);
            if (done_ >= total_) fmt::print(stderr, "\r\033[K");
        } else {
            fmt::print(stderr, "{}/{} {}\n", done_, total_, what);
        }
    }

private:
    std::size_t total_, done_ = 0;
    bool terminal_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

int run(const Arguments& arguments) {
    const std::vector<Case> cases = read_all(arguments);
    std::size_t steps = 0;
    for (const Case& one : cases) steps += one.sizes(arguments.level).size();
    Progress progress(std::max<std::size_t>(1, steps));
    const RunOptions options{arguments.level, arguments.out, [&](const std::string& line) { progress.step(line); }};
    std::vector<CaseResult> results;
    Timings timings;
    for (const Case& one : cases) {
        const auto start = std::chrono::steady_clock::now();
        CaseRun done = run_case(one, options);
        done.result.command = command_of(one, arguments);
        timings.add(one.name, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), done.solves);
        print(done.result);
        results.push_back(std::move(done.result));
    }
    const std::filesystem::path out = arguments.out;
    write_file_atomic(out / "timings.json", timings.json());
    write_file_atomic(out / "provenance.json", provenance_json(arguments.level));
    write_file_atomic(out / "results.csv", results_csv(results));
    write_file_atomic(out / "junit.xml", junit_xml(results));
    write_file_atomic(out / "results.json", results_json(results, arguments.level));
    if (!arguments.compare.empty()) fmt::print("{}", drift(results, arguments.compare));
    const Counts counts = count(results);
    fmt::print("{} passed, {} failed, {} info\n", counts.pass, counts.fail, counts.info);
    return static_cast<int>(counts.fail > 0 ? ExitCode::missed : ExitCode::ok);
}

int body(int argc, char** argv) {
    CLI::App app("Runs validation cases: particles against finite elements against mathematics.", "cleave validate");
    Arguments arguments;
    app.add_option("names", arguments.names, "names or globs of shipped cases, or case files (.toml); default: all");
    app.add_option("--level", arguments.level, "quick or full")->check(CLI::IsMember({"quick", "full"}));
    app.add_option("--ladder", arguments.ladder, "sizes instead of the case's own, like 0.2,0.1");
    app.add_option("--set", arguments.sets, "replace a value: KEY=VALUE with a dotted key")->allow_extra_args(false);
    app.add_option("--out", arguments.out, "folder of the results");
    app.add_option("--shard", arguments.shard, "I/N: every N-th case, starting with the I-th");
    app.add_option("--compare", arguments.compare, "an earlier results.json: print what drifted");
    app.add_flag("--list", arguments.list, "cases, shapes, solutions, solvers, quantities");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        fmt::print("{}", app.help());
        return 0;
    } catch (const CLI::ParseError& error) {
        throw InputError("", "cleave validate", fmt::format("valid options: {}", error.what()));
    }
    if (!arguments.compare.empty()) (void)drift({}, arguments.compare);  // a broken file is told before the computing
    if (arguments.list) {
        fmt::print("{}", listing());
        return 0;
    }
    return run(arguments);
}

}  // namespace
}  // namespace cleave::validation

int main(int argc, char** argv) { return cleave::run_program("cleave validate", cleave::validation::body, argc, argv); }
