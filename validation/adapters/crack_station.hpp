#pragma once

#include "validation/case.hpp"
#include "validation/geometry/crack_front.hpp"

namespace cleave::validation {

using analytic::Point;

/// A place of a crack's front and the growth about it that quantities of this place are taken with: all of a straight front; on a curved
/// one a hat about the place, a tenth of the loop wide in all.
struct CrackStation {
    geometry::CrackFront front;
    geometry::FrontPlace place;
    std::function<Point(const Point&)> growth;
};

/// The station nearest to a point. Throws std::invalid_argument where the body has no crack.
CrackStation station_near(const geometry::Shape& shape, const Point& point);

/// Growth of all fronts at once, m per m. Throws std::invalid_argument where the body has no crack.
std::function<Point(const Point&)> whole_growth(const geometry::Shape& shape);

/// K_c by the angle from the crack's plane (rad) at a station, over that of the weak plane: Saouma's cos^2 + ratio sin^2 of the angle between
/// crack plane and weak plane.
double relative_toughness(const Toughness& toughness, const CrackStation& station, double angle);

}  // namespace cleave::validation
