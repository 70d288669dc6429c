#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// Where a penny crack comes to rest, loaded by forces at its centre or from afar: G(a) = G_c by finite elements, by particles, in closed
/// form, and Eq. 11 as printed. An eighth of a cube on one mesh whose front is moved to several radii.
StudyInfo griffith_study();

}  // namespace cleave::validation
