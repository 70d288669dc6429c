#pragma once

#include "solver/elasticity/equilibrium.hpp"

#include <vector>

namespace cleave::elasticity {

/// A way for a crack to grow: how the vertices move per metre of growth. Zero at every boundary that does not grow with it, tangential to
/// the crack on its lips, continuous; the whole front, or a hat about one place of it.
struct CrackExtension {
    int crack_surface = 0;  ///< id of the lips
    VectorField growth;     ///< m per m
};

struct EnergyRelease {
    double by_movement = 0;         ///< J/m^2, moved vertices
    double by_domain_integral = 0;  ///< J/m^2, from the particle fields
    double width = 0;               ///< m: area the crack gains per metre of growth, the length of the front for a growth of one along it
};

/// Energy release rate G = -dPi/dA of a solved problem, Pi the potential energy of body and dead loads (Irwin 1956), twice over:
///
/// - by moved vertices: (Pi(-step) - Pi(step)) / (2 step width), the mesh's vertices moved by step times the growth, stencils, supports and
///   visibility as they were, loads evaluated where the faces now are. The displacements of the particles stay: Pi is stationary in them,
///   so that letting them relax changes the result by O(step^2) only (energy_release_by_solving shows it). `step` in m, 1e-3 of the
///   crack's size;
/// - by the domain integral (deLorenzi 1982): sum_i V_i (sigma_ab u_a,c q_c,b - w q_c,c) of the particle fields, q the growth as linear
///   elements interpolate it, plus the work of the loads on lips and inside that grow with it: sum t.u dA' and b.u dV' (loads taken as
///   uniform where the growth is not zero). It leaves the change of the stencils and the link penalty out.
///
/// Throws std::invalid_argument: growth that adds no crack area, vertices moved so far that a tet turns over.
std::vector<EnergyRelease> energy_release(const EquilibriumProblem& problem, const EquilibriumOptions& options,
                                          const EquilibriumSolution& solution, const std::vector<CrackExtension>& extensions, double step);

/// The same by two further solves on the moved bodies: slow, the oracle of by_movement. J/m^2.
double energy_release_by_solving(const EquilibriumProblem& problem, const EquilibriumOptions& options,
                                 const EquilibriumSolution& solution, const CrackExtension& extension, double step);

/// Area (m^2) the crack gains per metre of growth: half the change of the lips' area. Exact for plane cracks.
double crack_width(const mesh::TetMesh& mesh, const CrackExtension& extension);

/// Gradient dq_a/dx_b in a tet of a growth given at the vertices, linear in between.
Eigen::Matrix3d growth_gradient(const mesh::TetMesh& mesh, int tet, const std::vector<Eigen::Vector3d>& growth);

}  // namespace cleave::elasticity
