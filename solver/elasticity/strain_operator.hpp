#pragma once

#include "solver/particles/neighbourhood.hpp"

#include <string>
#include <vector>

namespace cleave::elasticity {

/// What an operator had to do about poor neighbourhoods: for reports.
struct OperatorReport {
    int particles = 0;
    int raised_supports = 0;  ///< particles whose support was enlarged and then satisfied particles::SupportRule
    int poor_supports = 0;    ///< particles that no size satisfied
    int fallbacks = 0;        ///< particles where a lower operator stands in, see make_strain_operator
};

/// Displacement gradients from the displacements of particles. Every operator here is linear in u_ji = u_j - u_i and so is given by
/// one vector d_ij (1/m) per pair (Eq. 10):
///
///   (grad u)_i = sum_j u_ji d_ij^T,   (grad u)_ab = du_a / dx_b
///
/// Plain data, so that the forces (Eq. 9), a vectorised pass and the tests all use the same numbers.
struct StrainOperator {
    std::string name;
    particles::NeighbourLists neighbours;
    std::vector<Eigen::Vector3d> weight;  ///< d_ij, parallel to neighbours.index
    OperatorReport report;

    std::span<const Eigen::Vector3d> weights_of(int i) const {
        return {weight.data() + neighbours.offset[i], neighbours.offset[i + 1] - neighbours.offset[i]};
    }
};

/// The names make_strain_operator knows.
std::vector<std::string> strain_operator_names();

/// Builds an operator by name, kernels as the particles carry them:
///
///   paper      d_ij = V_j grad W(x_i - x_j, G_i), Eq. 7 as printed: wrong by a floor that depends on h/s only, more at surfaces
///   corrected  d_ij = V_j K_i^-T grad W, K_i = particles::moment_matrix: exact for linear fields (Bonet and Lok 1999).
///              Falls back to the pseudo-inverse of K where its smallest singular value is below 1e-6 of its largest (particles in
///              a plane: the gradient across it is then zero).
///   quadratic  moving least squares of order 2 through u_i, with the weights that `corrected` implies (quadratic.cpp): exact for
///              quadratic fields too. Falls back to `corrected` where the neighbours do not determine the nine derivatives.
///
/// Takes the lists over: of millions of particles they are gigabytes. Throws InputError for an unknown name.
StrainOperator make_strain_operator(const std::string& name, const particles::Particles& particles,
                                    particles::Neighbourhood neighbourhood);

/// (grad u)_i of one particle, from the displacements (m) of all.
Eigen::Matrix3d displacement_gradient(const StrainOperator& op, int i, const std::vector<Eigen::Vector3d>& displacement);

/// (grad u)_i of every particle.
std::vector<Eigen::Matrix3d> displacement_gradients(const StrainOperator& op, const std::vector<Eigen::Vector3d>& displacement);

}  // namespace cleave::elasticity
