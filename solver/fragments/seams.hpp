#pragma once

#include "solver/fragments/surface.hpp"

namespace cleave::fragments {

/// Joins what rounding and non-conforming faces keep apart: points of unpaired edges nearer than `tolerance` (m) become one, and
/// unpaired edges are divided at such points on them (the triangle in a fan from the corner opposite, or about its centroid where
/// several of its edges are divided). Triangles that shrink to an edge vanish.
void close_seams(Surface& surface, double tolerance);

}  // namespace cleave::fragments
