#pragma once

#include "solver/particles/neighbours.hpp"

namespace cleave::particles {

/// When a neighbourhood is too poor for a strain (few neighbours, or nearly all in a plane), and how its support is enlarged.
struct SupportRule {
    int least_neighbours = 12;
    double least_moment = 0.05;  ///< smallest singular value of the moment matrix K; a full neighbourhood has K close to one
    double growth = 1.15;        ///< of h per round
    int rounds = 16;             ///< sizes tried: h grows to at most 9.4 times its value
};

struct SupportReport {
    int raised = 0;      ///< particles whose support was enlarged, which satisfies the rule
    int still_poor = 0;  ///< particles that no size satisfies, and that took the best tried: a long kernel pointing out of a corner,
                         ///< fewer particles than the rule asks for, all of them in a plane
};

struct Neighbourhood {
    NeighbourLists lists;
    SupportReport report;
};

/// K_i = sum_j V_j x_ji (grad W(x_i - x_j))^T, x_ji = x_j - x_i: one in a full neighbourhood, smaller at a surface. Not symmetric.
Eigen::Matrix3d moment_matrix(const Particles& particles, int i, std::span<const int> neighbours);

/// Neighbour lists, with the supports of poor neighbourhoods enlarged (tensor and support_radius change, the shape does not).
Neighbourhood build_neighbourhood(Particles& particles, const SupportRule& rule = {});

}  // namespace cleave::particles
