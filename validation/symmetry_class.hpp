#pragma once

#include "solver/material/voigt.hpp"

#include <string>
#include <vector>

namespace cleave::validation {

/// The eight elastic symmetry classes, from the fewest constants to the most.
const std::vector<std::string>& symmetry_classes();

/// The class of a stiffness (any unit) in whatever axes it stands, by its planes of mirror symmetry: 0 triclinic, 1 monoclinic,
/// 3 orthogonal ones orthotropic, 3 at 60 degrees trigonal, 5 tetragonal, 9 cubic, infinitely many through or across an axis
/// transversely isotropic, all isotropic (Chadwick, Vianello and Cowin 2001). A plane counts where mirroring changes the tensor by
/// less than `tolerance` of its norm (tables of constants are rounded to three or four digits), and by less than a quarter of what is
/// anisotropic in it; isotropic is what lies within `tolerance` of an isotropic tensor.
std::string symmetry_class(const material::Stiffness& stiffness, double tolerance = 2e-3);

}  // namespace cleave::validation
