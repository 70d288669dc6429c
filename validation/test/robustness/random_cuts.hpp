// Random tets cut by random planes, a great many.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace cleave::robustness {

/// What so many cuts left behind.
struct CutTally {
    long cuts = 0;                 ///< tets divided
    long children = 0;
    long negative = 0;             ///< children whose volume, stated or of their corners, is not above zero
    double worst_sum = 0;          ///< |sum of the children - parent| / L^3, of the stated volumes and of those of the corners
    double worst_stated = 0;       ///< |stated - of the corners| / L^3 of a child
    double smallest_share = 1;     ///< of a child in its parent
};

/// What a twin does to the engine's output before it is looked at: the children's stated volumes (m^3), the points made (m).
using Damage = std::function<void(std::vector<double>& volumes, std::vector<std::array<double, 3>>& points)>;

/// Cuts tets with corners anywhere in a cube, a tenth of them slivers with dihedral angles down to 1e-6, by random planes through it until at
/// least `cuts` tets have been divided. The same for the same seed.
CutTally cut_at_random(long cuts, unsigned seed, const Damage& damage = {});

}  // namespace cleave::robustness
