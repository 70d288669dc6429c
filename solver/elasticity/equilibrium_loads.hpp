#pragma once

#include "solver/elasticity/equilibrium.hpp"
#include "solver/elasticity/equilibrium_operator.hpp"

namespace cleave::elasticity {

/// The prescribed faces of a problem, masks and values of several conditions on one face merged. `surface` has the id of each face.
/// Throws std::invalid_argument: id on no boundary face, a component prescribed twice.
std::vector<PrescribedFace> prescribed_faces(const EquilibriumProblem& problem, const ConformingBody& body,
                                             const std::vector<int>& surface);

/// Tractions and pressures times area of every face, N. Throws std::invalid_argument: id on no boundary face.
Vectors surface_loads(const EquilibriumProblem& problem, const ConformingBody& body, const std::vector<int>& surface);

/// Forces (N) of surface loads and body forces on the particles: their work on any displacement is f.u.
Vectors external_forces(const EquilibriumProblem& problem, const ConformingBody& body, const Vectors& surface_loads);

/// Forces (N) on the particles by which Nitsche's form asks for the prescribed values g: the part of E(u) linear in g is -f.u.
Vectors nitsche_forces(const QuadraticEnergy& energy);

/// The part of Nitsche's energy that depends on g alone, J.
double nitsche_constant(const QuadraticEnergy& energy);

/// Throws std::invalid_argument where a connected piece of the body can move rigidly without work on the prescribed faces.
void check_held(const ConformingBody& body, const std::vector<int>& piece, const std::vector<PrescribedFace>& prescribed);

}  // namespace cleave::elasticity
