#pragma once

#include "solver/elasticity/equilibrium_operator.hpp"

#include <Eigen/SparseCore>

namespace cleave::elasticity {

/// K as a sparse matrix, from the particles' B_i and products of sparse matrices: shares no loop with StiffnessOperator, whose check it
/// is. About a thousand entries a row: for bodies of a few thousand particles.
Eigen::SparseMatrix<double> assemble_stiffness(const QuadraticEnergy& energy);

/// Solves K u = force by CHOLMOD. Throws std::runtime_error where K is not positive definite.
Vectors solve_by_cholesky(const Eigen::SparseMatrix<double>& stiffness, const Vectors& force);

}  // namespace cleave::elasticity
