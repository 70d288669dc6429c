#pragma once

#include "solver/mesh/recipes/occ_body.hpp"

namespace cleave::mesh {

/// The paper's glass window (Fig. 9; its sizes are not given, these are ours): a slab, centred about the z axis, from z = 0. Metres.
struct WindowShape {
    double width = 0.5;
    double height = 0.5;
    double thickness = 0.03;
};

OccBody window_body(const WindowShape& shape = {});

}  // namespace cleave::mesh
