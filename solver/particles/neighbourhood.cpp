#include "solver/particles/neighbourhood.hpp"

#include "solver/particles/kernel.hpp"

#include <Eigen/SVD>

namespace cleave::particles {

namespace {

bool is_poor(const Particles& particles, int i, std::span<const int> neighbours, const SupportRule& rule) {
    if (static_cast<int>(neighbours.size()) < rule.least_neighbours) return true;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment_matrix(particles, i, neighbours));
    return svd.singularValues()(2) < rule.least_moment;
}

void enlarge(Particles& particles, int i, double factor) {
    particles.support_radius[i] *= factor;
    particles.tensor[i] /= factor;
}

/// Enlarges the support of particle i until its neighbourhood is good or the rounds are used up; true where it is good.
bool raise(Particles& particles, const CellGrid& grid, int i, std::vector<int>& neighbours, const SupportRule& rule) {
    for (int round = 0; round < rule.rounds; ++round) {
        enlarge(particles, i, rule.growth);
        neighbours = neighbours_of_point(particles, grid, particles.position[i], particles.tensor[i]);
        std::erase(neighbours, i);
        if (!is_poor(particles, i, neighbours, rule)) return true;
    }
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
        std::vector<int> neighbours = neighbours_of_point(particles, grid, particles.position[i], particles.tensor[i]);
        std::erase(neighbours, i);
        if (is_poor(particles, i, neighbours, rule)) {
            ++result.report.raised;
            if (!raise(particles, grid, i, neighbours, rule)) ++result.report.still_poor;
        }
        result.lists.index.insert(result.lists.index.end(), neighbours.begin(), neighbours.end());
        result.lists.offset.push_back(result.lists.index.size());
    }
    return result;
}

}  // namespace cleave::particles
