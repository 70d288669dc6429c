#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// Algorithm 1 in a block under a contact, with the paper's half-space displacement, against the closed form: stress, normal and gap of
/// each group; which way of grouping finds cracks; numbering; number of groups; inner radius; a crack that enters a second material; kernel
/// axes.
StudyInfo algorithm_1_study();

}  // namespace cleave::validation
