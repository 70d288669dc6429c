#pragma once

#include "solver/elasticity/strain_operator.hpp"
#include "solver/elasticity/strain.hpp"

#include <string>
#include <vector>

namespace cleave::validation {

/// A strain operator with the displacements it was given: what the force quantities are computed from.
struct OperatorState {
    particles::Particles particles;
    elasticity::StrainOperator op;
    elasticity::Solid solid;
    std::vector<Eigen::Vector3d> displacement;
};

/// net_force, net_torque, force_error, force_error_as_printed, rotated_energy_error.
bool is_force_quantity(const std::string& quantity);

/// All without dimension: sums over the sum of magnitudes, errors over the largest force. Finite differences are central, of the
/// energy, for 20 particles spread over the body.
double force_quantity(const OperatorState& state, const std::string& quantity);

}  // namespace cleave::validation
