#pragma once

#include "reference_fem/discretization.hpp"

namespace cleave::fem {

/// Prescribed displacements by dof. Throws Error where two conditions contradict each other (by more than 1e-8 of the largest prescribed
/// value), where a value is not finite, and where a part of the body can still move rigidly: the six rigid motions, seen at the
/// prescribed components, must be independent.
PrescribedValues prescribe(const Problem& problem, const Mesh& mesh, const FaceTable& faces, const Discretization& space);

}  // namespace cleave::fem
