#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// A rigid punch or sphere on a half-space of any stiffness, by finite elements on a block: force, depth, contact radius, pressure.
StudyInfo fem_indentation_study();

}  // namespace cleave::validation
