#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// The kernel of Eq. 4 against what it must be: unit integral, gradient of itself, unchanged when kernel and distance turn together (Eq. 6
/// in its right form and as printed), and the isotropic kernel where G = I/h. No keys.
StudyInfo kernel_properties_study();

}  // namespace cleave::validation
