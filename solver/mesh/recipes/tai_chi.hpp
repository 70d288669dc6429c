#pragma once

#include "solver/mesh/recipes/occ_body.hpp"

namespace cleave::mesh {

/// The paper's Tai Chi ornament (Fig. 12; its sizes are not given, these are ours): a disc about the z axis, from z = 0, split by the
/// S-curve into two materials, each with a dot of the other. The S-curve of the classical figure touches the rim and leaves two cusps,
/// in which any tet is flat; here it runs straight into the rim, at a right angle, over the length `neck`: no part is
/// thinner than `neck`. Metres.
struct TaiChiShape {
    double radius = 0.1;
    double thickness = 0.03;
    double neck = 0.02;
    double dot_radius = 0.018;
};

/// Regions 1 "yin" (the half x > 0 at the rim, and the upper dot) and 2 "yang".
OccBody tai_chi_body(const TaiChiShape& shape = {});

}  // namespace cleave::mesh
