#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace cleave::benchmarks {

/// How one counter of one row changed between two runs.
struct Change {
    std::string row, counter;
    double old_value = 0, new_value = 0;
    double ratio = 1;      ///< new / old, or old / new for a speedup: above 1 is worse
    double noise = 0;      ///< the relative change that noise explains
    std::string verdict;   ///< "same", "worse" (a regression), "better"
};

/// A row whose two runs did different work: nothing can be said about its cost.
struct Mismatch {
    std::string row, counter;
    double old_value = 0, new_value = 0;
};

struct Comparison {
    std::vector<Change> changes;
    std::vector<Mismatch> mismatches;
    std::vector<std::string> missing;  ///< rows that the baseline has and the new run does not
};

/// Judges ratios taken within one process and instruction counts, never times: counters ratio_to_X (ours over X, lower is better),
/// speedup_over_X (X over ours, higher is better), instructions_per_X (lower is better). The noise of a ratio stands beside it as
/// noise_to_X or noise_over_X (relative, one sigma); a change is real where it exceeds three times the noise of both runs together
/// and the least change of its kind: 10 % for ratios (they follow the memory's load), 1 % for instructions. Two-sided: a change for
/// the better is told as well, since it asks for a new baseline.
/// Every other counter that counts work (particles_*, uncut, n31, n22, extra_links, children, fragments, removed_links, isolated, neighbours, bytes,
/// work_*) must be equal.
Comparison compare(const nlohmann::json& old_run, const nlohmann::json& new_run);

/// A table: row, counter, old, new, ratio, noise, verdict.
std::string table(const Comparison& comparison);

/// 2 where work differs or no counter could be compared (refused), 1 where something became worse, else 0.
int exit_code(const Comparison& comparison);

}  // namespace cleave::benchmarks
