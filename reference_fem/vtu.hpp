#pragma once

#include "reference_fem/solution.hpp"

#include <string>

namespace cleave::fem {

/// The solution as a VTK unstructured grid of straight-sided tets of its own degree (cell types 10 and 24), raw appended data, compressed by
/// zlib, 64-bit headers. Points: displacement, m. Cells: stress, Pa, and strain at the centroid (xx, yy, zz, yz, xz, xy; engineering shear),
/// region, and error: the estimate of Solution::cell_errors over the square root of the volume, sqrt(J/m^3). The same solution gives the
/// same bytes.
std::string vtu_text(const Solution& solution);

}  // namespace cleave::fem
