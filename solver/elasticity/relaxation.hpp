#pragma once

#include "solver/elasticity/strain.hpp"

#include <vector>

namespace cleave::elasticity {

/// Explicit damped relaxation of the forces of Eq. 9: what a particle code does when it steps until nothing moves.
///
/// Kept as a counter-example. The energy behind these forces, sum_i V_i eps_i:C:eps_i / 2 with the strain of `paper` or `corrected`, is
/// integrated at the particles only, and sum_i V_i d_ij is not the boundary integral that a constant stress would need: even a constant
/// stress is not in balance, and the solution does not converge as the particles are refined. `conforming` (equilibrium.hpp) does.
struct RelaxationProblem {
    const StrainOperator& op;
    const particles::Particles& particles;
    const Solid& solid;
    std::vector<Eigen::Vector3d> load;          ///< N per particle
    std::vector<bool> held;                     ///< particles that keep their first displacement
    std::vector<Eigen::Vector3d> displacement;  ///< m, the first guess, and what the held ones keep
};

struct RelaxationOptions {
    double tolerance = 1e-4;  ///< of the largest force left on a free particle over the largest at the start
    int max_steps = 20000;
};

struct Relaxation {
    std::vector<Eigen::Vector3d> displacement;  ///< m
    int steps = 0;
    double residual = 0;  ///< as in RelaxationOptions; above the tolerance where the steps ran out
};

/// Leapfrog with masses scaled so that every particle allows the same time step, and the damping critical for the motion under way
/// (adaptive dynamic relaxation, Underwood 1983). Throws std::invalid_argument where the arrays differ in length or every particle is held.
Relaxation relax(const RelaxationProblem& problem, const RelaxationOptions& options = {});

}  // namespace cleave::elasticity
