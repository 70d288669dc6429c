#pragma once

#include "reference_fem/problem.hpp"
#include "reference_fem/solution.hpp"

namespace cleave::fem {

/// Solves div C : grad u + body_force = 0 on straight-sided tetrahedra of degree 1 or 2 (deal.II's FE_SimplexP).
/// Throws Error, one line, for an unreadable mesh, an inverted or flat tet, an unknown surface or one with faces inside the body,
/// a region without stiffness, a stiffness that is not symmetric positive definite, displacements that contradict each other,
/// a body (or a loose part of one) that can still move rigidly, a free body that is held or has no density, a value that is not finite, an iteration that does not converge.
/// Repeated runs on one machine give the same bits.
Solution solve(const Problem& problem, const Options& options = {});

}  // namespace cleave::fem
