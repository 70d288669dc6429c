#include "solver/mesh/size_tuning.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace cleave::mesh {
namespace {

constexpr int most_rounds = 7;
constexpr double near_enough = 0.005;
/// Some meshers' counts go up and down with the size: a miss is worth some more rounds.
constexpr int most_rounds_of_a_miss = 10;

/// (log of the size, log of count / target)
struct Trial {
    double log_size;
    double log_ratio;
};

double next_log_size(const Trial& last, const std::optional<Trial>& too_many, const std::optional<Trial>& too_few) {
    if (!too_many || !too_few) return last.log_size + last.log_ratio / 2.5;
    const double share = too_many->log_ratio / (too_many->log_ratio - too_few->log_ratio);
    return too_many->log_size + std::clamp(share, 0.1, 0.9) * (too_few->log_size - too_many->log_size);
}

}  // namespace

bool misses(const TetMesh& mesh, int target) { return std::abs(static_cast<double>(mesh.tets.size()) - target) > count_tolerance * target; }

TunedMesh tune_count(const std::function<TetMesh(double size)>& make, double first_size, int target) {
    if (target < 1 || !(first_size > 0)) throw std::invalid_argument("tune_count: target and first size must be positive");
    TunedMesh best;
    double best_miss = 0;
    std::optional<Trial> too_many, too_few;
    double log_size = std::log(first_size);
    for (int round = 1; round <= (misses(best.mesh, target) ? most_rounds_of_a_miss : most_rounds); ++round) {
        TetMesh mesh = make(std::exp(log_size));
        const Trial trial{log_size, std::log(static_cast<double>(mesh.tets.size()) / target)};
        (trial.log_ratio > 0 ? too_many : too_few) = trial;
        if (round == 1 || std::abs(trial.log_ratio) < best_miss) {
            best_miss = std::abs(trial.log_ratio);
            best.mesh = std::move(mesh);
            best.size = std::exp(log_size);
        }
        best.rounds = round;
        if (too_few) best.size_of_too_few = std::exp(too_few->log_size);
        if (best_miss <= near_enough) break;
        log_size = next_log_size(trial, too_many, too_few);
    }
    return best;
}

}  // namespace cleave::mesh
