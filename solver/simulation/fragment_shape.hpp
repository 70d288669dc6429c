#pragma once

#include "solver/fragments/surface.hpp"
#include "solver/simulation/animation.hpp"

namespace cleave::simulation {

/// Outer and crack faces of a fragment.
Shape shape_of(const fragments::Surface& surface);

/// A ball about the origin, by meridians and parallels.
Shape ball_shape(double radius);

}  // namespace cleave::simulation
