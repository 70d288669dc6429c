#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// Half-space fields of the `surfaces` named (at level full of every material of the catalogue) under a point force and under Hertz's pressure, both oblique: the solver's closed
/// form or Stroh sum (key `form`) against the analytic half-spaces (Boussinesq and its quadrature where isotropic, Fourier transform else), their stress
/// against differences of their displacement, the divergence of it, and the force that goes through
/// a hemisphere, this for every material.
StudyInfo contact_fields_study();

}  // namespace cleave::validation
