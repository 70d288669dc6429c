#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// Rankine's two readings under one homogeneous stress: direction and gap of the largest principal stress and strain, and the angle between
/// the two directions. The stress is given in the material's axes by its principal values, turned about z.
StudyInfo principal_directions_study();

}  // namespace cleave::validation
