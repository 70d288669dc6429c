#include "solver/particles/neighbourhood.hpp"

#include "solver/particles/kernel.hpp"
#include "solver/particles/nearest.hpp"

#include <Eigen/SVD>

#include <cmath>

namespace cleave::particles {

namespace {

/// How good a neighbourhood is: first by having enough neighbours, then by its smallest moment, where `alike` ones are equal.
struct Quality {
    bool enough = false;
    double moment = 0;

    bool satisfies(const SupportRule& rule) const { return enough && moment >= (1 - alike) * rule.least_moment; }
    bool beats(const Quality& other) const { return enough != other.enough ? enough : moment > (1 + alike) * other.moment; }
};

Quality quality(const Particles& particles, int i, std::span<const int> neighbours, const SupportRule& rule) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment_matrix(particles, i, neighbours));
    return {static_cast<int>(neighbours.size()) >= rule.least_neighbours, svd.singularValues()(2)};
}

void scale_support(Particles& particles, int i, double factor) {
    particles.support_radius[i] *= factor;
    particles.tensor[i] /= factor;
}

std::vector<int> others_in_support(const Particles& particles, const CellGrid& grid, int i) {
    std::vector<int> neighbours = neighbours_of_point(particles, grid, particles.position[i], particles.tensor[i]);
    std::erase(neighbours, i);
    return neighbours;
}

/// Enlarges the support of particle i to the first size that satisfies the rule, else to the best size tried: beyond the body
/// moments shrink again. True where the rule is satisfied.
bool raise(Particles& particles, const CellGrid& grid, int i, std::vector<int>& neighbours, const SupportRule& rule) {
    const double radius = particles.support_radius[i];
    const Eigen::Matrix3d tensor = particles.tensor[i];
    const auto try_size = [&](int round) {
        particles.support_radius[i] = radius;
        particles.tensor[i] = tensor;
        scale_support(particles, i, std::pow(rule.growth, round));
        neighbours = others_in_support(particles, grid, i);
        return quality(particles, i, neighbours, rule);
    };
    Quality best;
    int best_round = 0;
    for (int round = 0; round <= rule.rounds; ++round) {
        const Quality found = try_size(round);
        if (found.satisfies(rule)) return true;
        if (found.beats(best)) best = found, best_round = round;
    }
    try_size(best_round);
    return false;
}

}  // namespace

Eigen::Matrix3d moment_matrix(const Particles& particles, int i, std::span<const int> neighbours) {
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (const int j : neighbours) {
        const Eigen::Vector3d x_ji = particles.position[j] - particles.position[i];
        moment += particles.volume[j] * x_ji * kernel_gradient(-x_ji, particles.tensor[i]).transpose();
    }
    return moment;
}

Neighbourhood build_neighbourhood(Particles& particles, const SupportRule& rule) {
    const CellGrid grid(particles.position, suitable_cell(particles));
    Neighbourhood result;
    result.lists.offset.push_back(0);
    for (int i = 0; i < particles.size(); ++i) {
        std::vector<int> neighbours = others_in_support(particles, grid, i);
        if (!quality(particles, i, neighbours, rule).satisfies(rule)) {
            const bool mended = raise(particles, grid, i, neighbours, rule);
            ++(mended ? result.report.raised : result.report.still_poor);
        }
        result.lists.index.insert(result.lists.index.end(), neighbours.begin(), neighbours.end());
        result.lists.offset.push_back(result.lists.index.size());
    }
    return result;
}

}  // namespace cleave::particles
