#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// Stress, principal direction and energy of the particles in the neighbourhood of a contact, several ways on one body: the analytic
/// half-space, the solver's half-space displacement through each strain operator, equilibrium of the free body by conforming particles,
/// quadratic finite elements on the same free body; and the isotropic half-space of Hill's mean moduli, as the paper takes it.
/// Keys: `surfaces` (level quick) and `surfaces_full`, `sizes` and `sizes_full` (tet edges over the contact radius, coarse to fine).
StudyInfo contact_cross_study();

}  // namespace cleave::validation
