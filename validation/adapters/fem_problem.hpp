#pragma once

#include "reference_fem/problem.hpp"
#include "validation/case.hpp"

namespace cleave::validation {

/// The case's body, materials and loads as the finite element reference takes them. Throws InputError.
fem::Problem fem_problem(const Case& of, const geometry::Body& body);

}  // namespace cleave::validation
