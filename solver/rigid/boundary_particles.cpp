#include "solver/rigid/boundary_particles.hpp"

#include "solver/particles/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

namespace cleave::rigid {
namespace {

std::vector<int> seed_order(const std::vector<SurfaceParticle>& surface) {
    std::vector<int> order(surface.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int i) {
        const SurfaceParticle& p = surface[i];
        return std::make_tuple(p.position[0], p.position[1], p.position[2], p.id);
    };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
    return order;
}

std::vector<Eigen::Vector3d> positions(const std::vector<SurfaceParticle>& surface) {
    std::vector<Eigen::Vector3d> points;
    for (const SurfaceParticle& particle : surface) points.push_back(particle.position);
    return points;
}

double mean_spacing(const std::vector<SurfaceParticle>& surface) {
    double sum = 0;
    for (const SurfaceParticle& particle : surface) sum += std::cbrt(particle.volume);
    return sum / static_cast<double>(surface.size());
}

BoundaryParticle merged(const std::vector<SurfaceParticle>& surface, std::vector<int> members) {
    BoundaryParticle particle{.position = Eigen::Vector3d::Zero(), .members = std::move(members)};
    double volume = 0;
    for (const int i : particle.members) {
        particle.position += surface[i].mass * surface[i].position;
        particle.mass += surface[i].mass;
        volume += surface[i].volume;
    }
    particle.position /= particle.mass;
    particle.radius = std::cbrt(3 * volume / (4 * std::numbers::pi));
    return particle;
}

/// The nearest free ones about a seed.
class Grouping {
public:
    Grouping(const std::vector<SurfaceParticle>& surface, const BoundaryRule& rule)
        : surface_(surface), rule_(rule), grid_(positions(surface), rule.reach * mean_spacing(surface)), free_(surface.size(), true) {}

    bool is_free(int i) const { return free_[i]; }

    /// The seed and its group - 1 nearest, or nothing where too few are in reach.
    std::vector<int> group_of(int seed) {
        const double reach = rule_.reach * std::cbrt(surface_[seed].volume);
        const Eigen::Vector3d& centre = surface_[seed].position;
        const Eigen::Vector3d half = Eigen::Vector3d::Constant(reach);
        candidates_.clear();
        grid_.collect(centre - half, centre + half, candidates_);
        std::vector<std::pair<double, int>> near;
        for (const int i : candidates_) {
            const double distance = (surface_[i].position - centre).norm();
            if (i != seed && free_[i] && distance <= reach) near.emplace_back(distance, i);
        }
        const std::size_t wanted = static_cast<std::size_t>(rule_.group) - 1;
        if (near.size() < wanted) return {};
        std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(wanted), near.end());
        std::vector<int> members{seed};
        for (std::size_t k = 0; k < wanted; ++k) members.push_back(near[k].second);
        for (const int i : members) free_[i] = false;
        return members;
    }

private:
    const std::vector<SurfaceParticle>& surface_;
    BoundaryRule rule_;
    particles::CellGrid grid_;
    std::vector<bool> free_;
    std::vector<int> candidates_;
};

}  // namespace

std::vector<BoundaryParticle> boundary_particles(const std::vector<SurfaceParticle>& surface, const BoundaryRule& rule) {
    std::vector<BoundaryParticle> result;
    if (surface.empty()) return result;
    Grouping grouping(surface, rule);
    const std::vector<int> order = seed_order(surface);
    for (const int seed : order) {
        if (!grouping.is_free(seed)) continue;
        std::vector<int> members = grouping.group_of(seed);
        if (!members.empty()) result.push_back(merged(surface, std::move(members)));
    }
    for (const int i : order)
        if (grouping.is_free(i)) result.push_back(merged(surface, {i}));
    return result;
}

}  // namespace cleave::rigid
