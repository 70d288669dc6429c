#pragma once

#include "validation/solutions.hpp"

namespace cleave::validation {

/// The analytic solutions of bodies with cracks, with their keys, as `solutions()` lists them.
const std::vector<SolutionInfo>& crack_solutions();

/// True for a name among them.
bool is_crack_solution(const std::string& name);

/// Makes one for the case's shape. Throws std::invalid_argument (a key, a shape or a material it is not for).
analytic::Field make_crack_field(const SolutionCall& call, const Case& of, const analytic::Stiffness& stiffness);

}  // namespace cleave::validation
