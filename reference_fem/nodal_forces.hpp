#pragma once

#include "reference_fem/solution_data.hpp"

#include <span>

namespace cleave::fem {

/// Nodal forces int sigma_ij phi,j dV, N by dof, of the displacement that `data` holds, from some of its cells.
std::vector<double> internal_forces(const Solution::Data& data, std::span<const int> cells);

/// Energy and work by their own quadrature of the solution, apart from the matrix. At a prescribed dof the internal force is load plus
/// reaction; elsewhere the load is taken. Returns the internal forces.
std::vector<double> add_energies(Solution::Data& data, const std::vector<double>& load, const PrescribedValues& prescribed);

}  // namespace cleave::fem
