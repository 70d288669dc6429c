#include "benchmarks/compare.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace cleave::benchmarks {
namespace {

using nlohmann::json;

constexpr double least_change_of_ratio = 0.10, least_change_of_instructions = 0.01, sigmas = 3;

/// Counters of a row: numbers that are not Google Benchmark's own.
std::map<std::string, double> counters(const json& row) {
    static const std::set<std::string> own{"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads",
                                           "iterations", "real_time", "cpu_time"};
    std::map<std::string, double> found;
    for (const auto& [key, value] : row.items()) {
        if (value.is_number() && !own.contains(key)) found[key] = value.get<double>();
    }
    return found;
}

std::map<std::string, std::map<std::string, double>> rows(const json& run) {
    std::map<std::string, std::map<std::string, double>> found;
    for (const json& row : run.at("benchmarks")) {
        if (row.value("run_type", "iteration") == "iteration") found[row.at("name").get<std::string>()] = counters(row);
    }
    return found;
}

bool is_ratio(const std::string& counter) { return counter.starts_with("ratio_to_"); }
bool is_speedup(const std::string& counter) { return counter.starts_with("speedup_over_"); }
bool is_instructions(const std::string& counter) { return counter.starts_with("instructions_per_"); }

bool is_work(const std::string& counter) {
    static const std::set<std::string> names{"uncut", "n31", "n22", "extra_links", "children", "fragments", "removed_links", "isolated",
                                             "neighbours", "bytes"};
    return names.contains(counter) || counter.starts_with("particles_") || counter.starts_with("work_");
}

double noise_of(const std::map<std::string, double>& row, const std::string& counter) {
    const std::string key = is_ratio(counter) ? "noise_to_" + counter.substr(9) : "noise_over_" + counter.substr(13);
    const auto at = row.find(key);
    return at == row.end() ? 0 : at->second;
}

Change judge(const std::string& row, const std::string& counter, const std::map<std::string, double>& before,
             const std::map<std::string, double>& after) {
    Change change{row, counter, before.at(counter), after.at(counter), 1, 0, "same"};
    change.ratio = is_speedup(counter) ? change.old_value / change.new_value : change.new_value / change.old_value;
    if (is_instructions(counter)) {
        change.noise = least_change_of_instructions;
    } else {
        change.noise = std::max(least_change_of_ratio, sigmas * std::hypot(noise_of(before, counter), noise_of(after, counter)));
    }
    if (!(change.ratio <= 1 + change.noise)) change.verdict = "worse";  // NaN is worse
    else if (change.ratio < 1 / (1 + change.noise)) change.verdict = "better";
    return change;
}

}  // namespace

Comparison compare(const json& old_run, const json& new_run) {
    Comparison found;
    const auto after = rows(new_run);
    for (const auto& [name, before] : rows(old_run)) {
        const auto at = after.find(name);
        if (at == after.end()) {
            found.missing.push_back(name);
            continue;
        }
        std::vector<Change> changes;
        bool same_work = true;
        for (const auto& [counter, value] : before) {
            const auto now = at->second.find(counter);
            if (now == at->second.end()) continue;
            if (is_work(counter) && now->second != value) {
                found.mismatches.push_back({name, counter, value, now->second});
                same_work = false;
            }
            if (is_ratio(counter) || is_speedup(counter) || is_instructions(counter)) changes.push_back(judge(name, counter, before, at->second));
        }
        if (same_work) found.changes.insert(found.changes.end(), changes.begin(), changes.end());
    }
    return found;
}

std::string table(const Comparison& comparison) {
    std::string text = fmt::format("{:<40} {:<34} {:>12} {:>12} {:>8} {:>8}  {}\n", "row", "counter", "old", "new", "ratio", "noise", "verdict");
    for (const Change& change : comparison.changes) {
        text += fmt::format("{:<40} {:<34} {:>12.5g} {:>12.5g} {:>8.3f} {:>7.1f}%  {}\n", change.row, change.counter, change.old_value,
                            change.new_value, change.ratio, 100 * change.noise, change.verdict);
    }
    for (const Mismatch& mismatch : comparison.mismatches) {
        text += fmt::format("{:<40} {:<34} {:>12.10g} {:>12.10g} {:>8} {:>8}  refused: not the same work\n", mismatch.row, mismatch.counter,
                            mismatch.old_value, mismatch.new_value, "", "");
    }
    for (const std::string& row : comparison.missing) text += fmt::format("{:<40} only in the baseline\n", row);
    return text;
}

int exit_code(const Comparison& comparison) {
    if (!comparison.mismatches.empty() || comparison.changes.empty()) return 2;
    const bool worse = std::any_of(comparison.changes.begin(), comparison.changes.end(), [](const Change& c) { return c.verdict == "worse"; });
    return worse ? 1 : 0;
}

}  // namespace cleave::benchmarks
