#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// Many tensors through the same checks (tensor_checks.hpp): the catalogue and seeded random ones of every symmetry class, or a user's table.
/// A value is the worst of a class; its detail names the tensor. sweep.csv has the errors of all, tensors.csv their names and constants.
StudyInfo material_sweep_study();

}  // namespace cleave::validation
