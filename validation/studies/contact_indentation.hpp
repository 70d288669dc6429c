#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// Indentation modulus of the `surfaces` named (at level full of every material), the surface's compliance by direction, and the paraboloid under Hertz's pressure:
/// Stroh's eigenvectors in the solver, the integrals of Barnett and Lothe in the analytic half-space.
StudyInfo contact_indentation_study();

}  // namespace cleave::validation
