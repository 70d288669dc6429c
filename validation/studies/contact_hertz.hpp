#pragma once

#include "validation/study.hpp"

namespace cleave::validation {

/// Hertz's contact in numbers: sphere on a plane, largest tension and shear of its field, an elliptical contact whose pressure must fit
/// the curvatures it was made for, and an impact against the equation of motion. No keys.
StudyInfo contact_hertz_study();

}  // namespace cleave::validation
