#include "validation/run_suite.hpp"

#include "solver/parallel/on_threads.hpp"
#include "validation/processes.hpp"
#include "validation/runner.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace cleave::validation {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A bar with the remaining time on a terminal, a plain line elsewhere; on stderr, so that stdout holds results only.
class Progress {
public:
    explicit Progress(std::size_t total) : total_(std::max<std::size_t>(1, total)), terminal_(isatty(STDERR_FILENO) != 0) {}
    void step(const std::string& what) {
        const std::size_t done = std::min(done_.next() + 1, total_);
        if (!terminal_) {
            fmt::print(stderr, "{}/{} {}\n", done, total_, what);
            return;
        }
        const double left = seconds_since(start_) / static_cast<double>(done) * static_cast<double>(total_ - done);
        fmt::print(stderr, "\r\033[K[{:-<30}] {:.0f} s left  {}", std::string(30 * done / total_, '#'), left, what);
        if (done == total_) fmt::print(stderr, "\r\033[K");
    }

private:
    std::size_t total_;
    bool terminal_;
    SharedCounter done_;
    Clock::time_point start_ = Clock::now();
};

FinishedCase run_one(const Case& of, const SuiteOptions& options, Progress& progress) {
    const auto start = Clock::now();
    CaseRun run = run_case(of, {options.level, options.out, [&](const std::string& line) { progress.step(line); }});
    run.result.command = of.command;
    return {std::move(run.result), seconds_since(start), std::move(run.solves), of.position};
}

/// Numbers of the cases that must run.
std::vector<std::size_t> open_cases(const std::vector<Case>& cases, const SuiteOptions& options, const CaseStore& store) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < cases.size(); ++i)
        if (!options.reuse || !store.find(cases[i])) open.push_back(i);
    return open;
}

std::size_t steps_of(const std::vector<Case>& cases, const std::vector<std::size_t>& chosen, const std::string& level) {
    std::size_t steps = 0;
    for (const std::size_t i : chosen) steps += cases[i].sizes(level).size();
    return steps;
}

void run_here(std::size_t k, int threads, const std::function<void(std::size_t)>& work) {
    if (threads == 0)
        work(k);
    else
        parallel::on_threads(threads, [&] { work(k); });
}

}  // namespace

std::vector<FinishedCase> run_suite(const std::vector<Case>& cases, const SuiteOptions& options,
                                    const std::function<void(std::size_t, FinishedCase&)>& finished) {
    const CaseStore store(options.out, options.level);
    const std::vector<std::size_t> open = open_cases(cases, options, store);
    if (open.size() < cases.size()) fmt::print(stderr, "{} of {} cases are finished already\n", cases.size() - open.size(), cases.size());
    Progress progress(steps_of(cases, open, options.level));
    const auto run_and_save = [&](std::size_t k) { store.save(cases[open[k]], run_one(cases[open[k]], options, progress)); };
    const bool parallel = options.jobs > 1 && open.size() > 1;
    if (parallel) {
        for (const std::size_t i : open) store.remove(cases[i]);  // an earlier run's file must not stand in for one that fails now
        const int jobs = std::min(options.jobs, static_cast<int>(open.size()));
        if (const int code = run_in_processes(open.size(), jobs, options.threads, run_and_save)) throw SuiteFailed{code};
    }
    std::vector<FinishedCase> all;
    for (std::size_t i = 0, k = 0; i < cases.size(); ++i) {
        if (k < open.size() && open[k] == i) {
            if (!parallel) run_here(k, options.threads, run_and_save);
            ++k;
        }
        std::optional<FinishedCase> one = store.find(cases[i]);
        if (!one) throw std::logic_error("a finished case is missing: " + cases[i].name);
        finished(i, *one);
        all.push_back(std::move(*one));
    }
    return all;
}

}  // namespace cleave::validation
