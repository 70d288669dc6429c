#pragma once

#include "solver/input/table_reader.hpp"
#include "solver/material/voigt.hpp"

#include <optional>
#include <string>

namespace cleave::material {

struct GivenStiffness {
    Stiffness stiffness;   ///< Pa, in the material's own axes
    std::string symmetry;  ///< as Material::symmetry
};

/// Reads whichever of the keys stiffness, engineering, cubic is there (material.hpp has the forms); nothing where none is.
/// Throws InputError at the offending key: more than one form, values out of range, not symmetric, not positive definite.
std::optional<GivenStiffness> read_stiffness(TableReader& reader);

}  // namespace cleave::material
