#pragma once

#include "solver/elasticity/equilibrium.hpp"
#include "solver/elasticity/equilibrium_operator.hpp"

#include <memory>

namespace cleave::elasticity {

/// A problem on a body: its energy and its loads, ready to be solved or evaluated. The body may have been moved since it was made of
/// the problem's mesh.
struct EquilibriumSystem {
    std::shared_ptr<const ConformingBody> body;
    std::vector<int> surface;  ///< id per face, -1 without
    std::vector<int> piece;    ///< connected piece per particle
    QuadraticEnergy energy;
    Vectors surface_loads;     ///< N per face
    Vectors external_force;    ///< N per particle: surface loads and body force
    Vectors nitsche_force;     ///< N per particle
    double constant = 0;       ///< J, of the prescribed displacements

    /// Potential energy (J) of body and dead loads, which equilibrium makes stationary; `inertia` (N per particle, may be empty) is taken
    /// off the load.
    double potential(const Vectors& displacement, const Vectors& inertia = {}) const;
};

/// Throws std::invalid_argument as solve_equilibrium does.
EquilibriumSystem make_system(const EquilibriumProblem& problem, double link_penalty, std::shared_ptr<const ConformingBody> body);

/// Solves for the displacement from the first guess in `displacement` (resized if it has another size), fills the report's iterations
/// and residual. `inertia`: N per particle, the part of the load that the acceleration of a free body takes; empty otherwise.
void solve_system(const EquilibriumSystem& system, const EquilibriumOptions& options, const Vectors& inertia, Vectors& displacement,
                  EquilibriumReport& report);

/// |f - K u| / |f| with the loads of a held body.
double system_residual(const EquilibriumSystem& system, const Vectors& displacement);

/// Mass (kg) of every particle; density 1 where the problem gives none. Throws std::invalid_argument where it is not positive.
std::vector<double> masses(const EquilibriumProblem& problem, const particles::Particles& particles);

/// Mass times acceleration (N per particle) that balances the load on a free body, piece by piece. Empty for a held body.
Vectors inertia_forces(const EquilibriumProblem& problem, const EquilibriumSystem& system);

}  // namespace cleave::elasticity
