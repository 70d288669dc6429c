#pragma once

namespace cleave::mesh::netgen {

/// CPU time given to one meshing, s: ten times what the largest of the paper's bodies takes.
inline constexpr unsigned most_seconds = 300;

/// The smallest edge that curvature may ask for, as part of the size.
inline constexpr double smallest_part = 0.5;

/// Exit code of cleave-netgen: how far it came.
enum class Stage : int { done = 0, usage = 10, geometry = 11, edges = 12, surface = 13, volume = 14 };

}  // namespace cleave::mesh::netgen
