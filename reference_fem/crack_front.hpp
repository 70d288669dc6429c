#pragma once

#include "reference_fem/problem.hpp"

#include <array>
#include <functional>

namespace cleave::fem {

/// Where a point stands as seen from a crack front: `ahead` and `above` are its coordinates in the plane normal to the front, with the lips
/// at ahead < 0, above = 0; on a curved crack surface arc lengths, with the axes of the surface at the foot of the point.
struct FrontPlace {
    std::array<Point, 3> axes{};  ///< unit vectors: ahead (growth), normal to the crack, along the front; right-handed
    double ahead = 0, above = 0;  ///< m
    double along = 0;             ///< arc length along the front, m
};

/// A crack front inside one material.
struct CrackFront {
    std::function<FrontPlace(const Point&)> locate;
    std::function<Point(double along)> point_at;  ///< the place of the front at an arc length
    double length = 0;  ///< m, inside the body
    double loop = 0;    ///< m: the arc length after which a curved front repeats itself; 0 for a straight front, whose axes are the same all along
};

}  // namespace cleave::fem
