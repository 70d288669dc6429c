#pragma once

#include "reference_fem/discretization.hpp"

namespace cleave::fem {

/// Adds the nodal forces of loads per length: int phi_a t ds along the edges, by three Gauss points each. Throws Error (no such line, a
/// load that is missing or not finite).
void add_line_loads(const std::vector<LineLoad>& line_loads, const Mesh& mesh, const FaceTable& faces, const Discretization& space,
                    std::vector<double>& load);

}  // namespace cleave::fem
