#pragma once

#include "solver/mesh/recipes/occ_body.hpp"

namespace cleave::mesh {

/// The paper's pet (Fig. 11; its shape is not given, this one is ours): a hollow animal of porcelain on four legs, of ellipsoids and
/// cylinders, standing on z = 0, looking along x. Body and head have a cavity each. Metres.
struct PetShape {
    double length = 0.26;  ///< of the body
    double wall = 0.012;
};

OccBody pet_body(const PetShape& shape = {});

}  // namespace cleave::mesh
