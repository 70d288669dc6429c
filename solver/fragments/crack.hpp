#pragma once

#include "solver/subdivision/cut.hpp"

#include <optional>

namespace cleave::fragments {

/// How a crack opens a body (paper Fig. 3).
enum class Scheme {
    adaptive,  ///< Fig. 3d, e: the tets at the crack are subdivided, then the links that it intersects are removed
    basic,     ///< Fig. 3b, c: only the links are removed; cracks follow the faces of the initial mesh (left of Fig. 7)
};

/// One crack, in the body's rest coordinates.
struct Crack {
    subdivision::Cut disc;    ///< centre, normal, radius (the paper's r_outer, m; infinite: a whole plane)
    double inner_radius = 0;  ///< the paper's r_inner, m: particles whose centroid is nearer to the centre lose all links; 0: none
    /// The material's region that the crack breaks: tets of others stay whole, and only links between two tets of this one are lost.
    /// None: all (the interfaces between regions included).
    std::optional<int> region = std::nullopt;
};

}  // namespace cleave::fragments
