#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// Where the half-space stops being a plate: stress and predicted crack round a contact by the half-space against finite elements on free
/// plates of falling thickness (over the contact radius). Keys: `surfaces`, `thicknesses` (thick to thin), `size` (tet edge at the contact
/// over its radius), and for level full the same with `_full`.
StudyInfo contact_thin_wall_study();

}  // namespace cleave::validation
