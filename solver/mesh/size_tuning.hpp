#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <functional>

namespace cleave::mesh {

/// A mesh whose tet count comes close to a target, and the way there.
struct TunedMesh {
    TetMesh mesh;
    double size = 0;   ///< m: the mesh size that gave it
    int rounds = 0;    ///< meshes made
    double size_of_too_few = 0;  ///< m: the last size tried that gave fewer tets than the target; 0 where none did
};

/// A count is met within this part of it.
inline constexpr double count_tolerance = 0.02;
bool misses(const TetMesh& mesh, int target);

/// Meshes at sizes h until the count n is within 0.5 % of `target`, or for 7 rounds (10 where the nearest misses by more than 2 %), and keeps the nearest: first
/// h <- h (n / target)^(1/2.5) (between a surface's exponent 2 and a solid's 3), then, once the target is bracketed,
/// interpolation of log h in log n, kept 10 % inside the bracket. Deterministic if `make` is.
TunedMesh tune_count(const std::function<TetMesh(double size)>& make, double first_size, int target);

}  // namespace cleave::mesh
