#pragma once

#include "validation/expression.hpp"

#include <array>
#include <functional>
#include <string>

namespace cleave::geometry {

using validation::Point;

/// Where a point stands as seen from a crack front. In the plane normal to the front `ahead` and `above` are coordinates, the lips at
/// ahead < 0, above = 0; on a curved crack they are arc lengths, and the axes those of the crack's surface at the foot of the point.
struct FrontPlace {
    Point position{};             ///< nearest place of the front, m
    std::array<Point, 3> axes{};  ///< unit vectors: ahead (growth), normal to the crack, along the front; right-handed
    double ahead = 0, above = 0;  ///< m
    double along = 0;             ///< arc length of `position`, m
};

/// The front of a crack.
struct CrackFront {
    std::function<FrontPlace(const Point&)> locate;
    std::function<Point(double along)> point_at;  ///< the place of the front at an arc length
    double length = 0;  ///< m, inside the body
    double loop = 0;    ///< m: the arc length after which a curved front repeats itself; 0 for a straight one, whose axes are the same all along
    double reach = 0;       ///< m: no other front is nearer than this, and no boundary that the front does not end on
    std::string lips = "crack";  ///< the surface of both lips
    std::array<Point, 2> box{};  ///< m: growth does not leave the sides of this box, low and high corner
};

/// Distance from the front, m.
double distance(const FrontPlace& place);

/// A front along axes[2] through `origin`.
CrackFront straight_front(const Point& origin, const std::array<Point, 3>& axes, double length, double reach);

/// Front of an elliptical crack of half axes a along axes[0] and b along axes[1], normal axes[2]; `arc` (rad, of the circle or of the
/// ellipse's parameter) from axes[0] on is inside the body: 2 pi for a whole ellipse. Arc length is that of the parameter's polygon.
struct EllipseArc {
    Point centre{};
    std::array<Point, 3> axes{};
    double a = 0, b = 0, arc = 0;
};
CrackFront elliptical_front(const EllipseArc& ellipse, double reach);

/// Front of a cap of a sphere about `centre`: all points whose angle from `pole` (unit) is below half_angle; normal outward.
struct Cap {
    Point centre{}, pole{};
    double sphere_radius = 0, half_angle = 0;
};
CrackFront cap_front(const Cap& cap, double reach);

/// Growth of a front: one along `ahead` at the front, fading to zero at its reach. m per m.
Point uniform_growth(const CrackFront& front, const Point& point);

/// One along `ahead` up to half the reach, fading to zero at it, times a hat of half width `half_width` (m) about the arc length `along`.
Point local_growth(const CrackFront& front, double along, double half_width, const Point& point);

}  // namespace cleave::geometry
