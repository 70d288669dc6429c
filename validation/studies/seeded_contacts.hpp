#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// One scene's first body, whole, is hit at seeded places of its surface, once for each variant of the scene (the first variant is what the
/// others are compared with) and each strain operator: means over the places (place: the variant), changes against the first variant with the
/// half width of their 95 % interval (place: "VARIANT - FIRST"), and for bodies of two materials the mean direction of each one's cracks.
StudyInfo seeded_contacts_study();

}  // namespace cleave::validation
