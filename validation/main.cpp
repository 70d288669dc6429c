// cleave-validate: runs cases, compares particles, finite elements and mathematics, writes results.

#include "solver/input/command_line.hpp"
#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "validation/merge.hpp"
#include "validation/run_suite.hpp"
#include "validation/suite.hpp"
#include "validation/timings.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace cleave::validation {
namespace {

struct Arguments {
    std::vector<std::string> names, sets, from;
    std::string level = "quick", ladder, out = "out/validate", shard, compare;
    bool list = false, reuse = false;
    int jobs = 1, threads = 0;
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

std::string command_of(const Case& one, const Arguments& arguments) {
    const std::filesystem::path file = one.file;
    const std::vector<std::filesystem::path> shipped = shipped_case_files();
    const bool ours = !shipped.empty() && file.parent_path() == shipped.front().parent_path();
    std::string command = "cleave validate " + (ours ? file.stem() : file.filename()).string();
    for (const std::string& text : arguments.sets) command += fmt::format(" --set '{}'", text);
    if (!arguments.ladder.empty()) command += " --ladder " + arguments.ladder;
    return command + " --level " + arguments.level;
}

/// Everything is read before anything runs: a mistake in the last file costs no computing.
std::vector<Case> read_all(const Arguments& arguments) {
    std::vector<Case> cases;
    for (const std::filesystem::path& file : select_files(arguments.names))
        for (Case& one : read_cases(file.string(), overrides_of(arguments))) cases.push_back(std::move(one));
    for (std::size_t i = 0; i < cases.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (cases[i].name == cases[j].name) throw InputError(cases[i].file, "name", fmt::format("a name of its own ('{}' is also in {})", cases[i].name, cases[j].file));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        cases[i].position = i;
        cases[i].command = command_of(cases[i], arguments);
    }
    return arguments.shard.empty() ? cases : shard(cases, arguments.shard);
}

void print(const CaseResult& result) {
    fmt::print("{:4}  {}\n", name(result.verdict), result.name);
    for (const Row& row : result.rows) {
        const double error = row.relative ? row.measurement.relative_error : row.measurement.absolute_error;
        std::string text = fmt::format("  {:4}  {:14} {:12} {:3} {}", name(row.verdict), row.solver, row.quantity, row.component, place_text(row));
        if (row.measurement.value) text += fmt::format("  {:.6g} {}", *row.measurement.value, row.unit);
        if (row.measurement.reference) text += fmt::format(" against {:.6g}, error {:.3g}", *row.measurement.reference, error);
        if (row.measurement.order) text += fmt::format(", order {:.2f}", *row.measurement.order);
        fmt::print("{}{}\n", text, row.must_fail ? " (must fail)" : "");
    }
    std::fflush(stdout);
}

/// Everything but provenance.json, which a merged run has one of per folder.
int write_results(const std::vector<FinishedCase>& cases, const std::string& level, const Arguments& arguments) {
    std::vector<CaseResult> results;
    Timings timings;
    for (const FinishedCase& one : cases) {
        results.push_back(one.result);
        timings.add(one.result.name, one.seconds, one.solves);
    }
    const std::filesystem::path out = arguments.out;
    write_file_atomic(out / "timings.json", timings.json());
    write_file_atomic(out / "results.csv", results_csv(results));
    write_file_atomic(out / "junit.xml", junit_xml(results));
    write_file_atomic(out / "results.json", results_json(results, level));
    if (!arguments.compare.empty()) fmt::print("{}", drift(results, arguments.compare));
    const Counts counts = count(results);
    fmt::print("{} passed, {} failed, {} info\n", counts.pass, counts.fail, counts.info);
    return static_cast<int>(counts.fail > 0 ? ExitCode::missed : ExitCode::ok);
}

int run(const Arguments& arguments) {
    const std::vector<FinishedCase> finished =
        run_suite(read_all(arguments), {arguments.level, arguments.out, arguments.jobs, arguments.reuse, arguments.threads},
                  [](std::size_t, FinishedCase& one) { print(one.result); });
    write_file_atomic(std::filesystem::path(arguments.out) / "provenance.json", provenance_json(arguments.level));
    return write_results(finished, arguments.level, arguments);
}

int merge(const Arguments& arguments) {
    const MergedRun merged = merge_runs({arguments.from.begin(), arguments.from.end()}, arguments.out);
    return write_results(merged.cases, merged.level, arguments);
}

int body(int argc, char** argv) {
    CLI::App app("Runs validation cases: particles against finite elements against mathematics.", "cleave validate");
    Arguments arguments;
    app.add_option("names", arguments.names, "names or globs of shipped cases, or case files (.toml); default: all");
    app.add_option("--level", arguments.level, "quick or full")->check(CLI::IsMember({"quick", "full"}));
    app.add_option("--ladder", arguments.ladder, "sizes instead of the case's own, like 0.2,0.1");
    app.add_option("--set", arguments.sets, "replace a value: KEY=VALUE with a dotted key")->allow_extra_args(false);
    app.add_option("--out", arguments.out, "folder of the results");
    app.add_option("--jobs", arguments.jobs, "cases that run at the same time")->check(CLI::Range(1, 1024));
    app.add_option("--threads", arguments.threads, "threads of each case; default: its share of the cores. The numbers do not depend on it")->check(CLI::Range(1, 1024));
    app.add_flag("--reuse", arguments.reuse, "keep the finished cases of an earlier, perhaps interrupted, run into the same folder");
    app.add_option("--shard", arguments.shard, "I/N: every N-th case, starting with the I-th");
    app.add_option("--from", arguments.from, "folders of shards: run nothing, put their results together");
    app.add_option("--compare", arguments.compare, "an earlier results.json: print what drifted");
    app.add_flag("--list", arguments.list, "cases, shapes, solutions, solvers, quantities");
    if (!parse_command_line(app, argc, argv, "cleave validate", "valid options")) return 0;
    if (!arguments.compare.empty()) (void)drift({}, arguments.compare);  // a broken file is told before the computing
    if (arguments.list) {
        fmt::print("{}", listing());
        return 0;
    }
    try {
        return arguments.from.empty() ? run(arguments) : merge(arguments);
    } catch (const SuiteFailed& failed) {
        return failed.exit_code;
    }
}

}  // namespace
}  // namespace cleave::validation

int main(int argc, char** argv) { return cleave::run_program("cleave validate", cleave::validation::body, argc, argv); }
