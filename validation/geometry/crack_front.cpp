#include "validation/geometry/crack_front.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace cleave::geometry {

namespace {

constexpr double pi = std::numbers::pi;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point sum(const Point& a, double s, const Point& b) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }
Point cross(const Point& a, const Point& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
Point scaled(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }

/// Parameter t of the point (a cos t, b sin t) nearest to (x, y), by Newton's iteration on the quadrant's evolute (Robert Nurnberg's
/// scheme in the form of Eberly): converges from everywhere but the centre.
double nearest_parameter(double a, double b, double x, double y) {
    double t = std::atan2(a * std::abs(y), b * std::abs(x));
    for (int step = 0; step < 20; ++step) {
        const double c = std::cos(t), s = std::sin(t);
        const double slope = (a * a - b * b) * c * s - a * std::abs(x) * s + b * std::abs(y) * c;
        const double bend = (a * a - b * b) * (c * c - s * s) - a * std::abs(x) * c - b * std::abs(y) * s;
        const double move = bend < 0 ? slope / bend : 0;
        t = std::clamp(t - move, 0.0, pi / 2);
        if (std::abs(move) < 1e-15) break;
    }
    if (x < 0) t = pi - t;
    return y < 0 ? -t : t;
}

/// Arc length of an ellipse over its parameter, tabulated from 0 to 2 pi.
class ArcLength {
public:
    ArcLength(double a, double b) : table_(nodes + 1, 0.0) {
        for (int i = 0; i < nodes; ++i) {
            const double t = 2 * pi * (i + 0.5) / nodes;
            table_[static_cast<std::size_t>(i) + 1] = table_[static_cast<std::size_t>(i)] + 2 * pi / nodes * std::hypot(a * std::sin(t), b * std::cos(t));
        }
    }
    double operator()(double t) const {
        if (t < 0) t += 2 * pi;
        const double place = std::clamp(t / (2 * pi), 0.0, 1.0) * nodes;
        const auto cell = static_cast<std::size_t>(std::min<double>(std::floor(place), nodes - 1));
        const double share = place - static_cast<double>(cell);
        return (1 - share) * table_[cell] + share * table_[cell + 1];
    }
    double parameter(double length) const {
        const auto after = std::upper_bound(table_.begin() + 1, table_.end() - 1, length);
        const double share = (length - *(after - 1)) / (*after - *(after - 1));
        return 2 * pi * (static_cast<double>(after - table_.begin()) - 1 + share) / nodes;
    }

private:
    static constexpr int nodes = 3600;
    std::vector<double> table_;
};

/// From one at the front to zero at its reach.
double fade(const CrackFront& front, const FrontPlace& place) { return std::clamp(1 - distance(place) / front.reach, 0.0, 1.0); }

/// Share of `ahead`, without the component normal to a side of the box that the point lies on.
Point growth(const CrackFront& front, const FrontPlace& place, double share, const Point& point) {
    if (!(share > 0)) return {};
    Point q = scaled(share, place.axes[0]);
    for (std::size_t k = 0; k < 3; ++k) {
        const double low = front.box[0][k], high = front.box[1][k], near = 1e-9 * (high - low);
        if (std::abs(point[k] - low) < near || std::abs(point[k] - high) < near) q[k] = 0;
    }
    return q;
}

}  // namespace

double distance(const FrontPlace& place) { return std::hypot(place.ahead, place.above); }

CrackFront straight_front(const Point& origin, const std::array<Point, 3>& axes, double length, double reach) {
    const auto locate = [origin, axes](const Point& p) {
        const Point d = difference(p, origin);
        FrontPlace place{{}, axes, dot(d, axes[0]), dot(d, axes[1]), dot(d, axes[2])};
        place.position = sum(origin, place.along, axes[2]);
        return place;
    };
    return {locate, [origin, axes](double along) { return sum(origin, along, axes[2]); }, length, 0, reach, "crack", {}};
}

CrackFront elliptical_front(const EllipseArc& ellipse, double reach) {
    const auto arc_length = std::make_shared<const ArcLength>(ellipse.a, ellipse.b);
    const auto locate = [e = ellipse, arc_length](const Point& p) {
        const Point d = difference(p, e.centre);
        const double x = dot(d, e.axes[0]), y = dot(d, e.axes[1]);
        const double t = nearest_parameter(e.a, e.b, x, y), c = std::cos(t), s = std::sin(t);
        const double length = std::hypot(e.b * c, e.a * s);
        const Point ahead = sum(scaled(e.b * c / length, e.axes[0]), e.a * s / length, e.axes[1]);
        FrontPlace place;
        place.position = sum(sum(e.centre, e.a * c, e.axes[0]), e.b * s, e.axes[1]);
        place.axes = {ahead, e.axes[2], cross(ahead, e.axes[2])};
        place.ahead = (x - e.a * c) * e.b * c / length + (y - e.b * s) * e.a * s / length;
        place.above = dot(d, e.axes[2]);
        place.along = (*arc_length)(t);
        return place;
    };
    const auto point_at = [e = ellipse, arc_length](double along) {
        const double t = arc_length->parameter(along);
        return sum(sum(e.centre, e.a * std::cos(t), e.axes[0]), e.b * std::sin(t), e.axes[1]);
    };
    return {locate, point_at, (*arc_length)(ellipse.arc), (*arc_length)(2 * pi), reach, "crack", {}};
}

CrackFront cap_front(const Cap& cap, double reach) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(cap.pole[i]) < std::abs(cap.pole[least])) least = i;
    Point e{};
    e[least] = 1;
    Point first = cross(cap.pole, e);
    first = scaled(1 / std::sqrt(dot(first, first)), first);
    const Point second = cross(cap.pole, first);
    const auto locate = [cap, first, second](const Point& p) {
        const Point d = difference(p, cap.centre);
        const double x = dot(d, first), y = dot(d, second), z = dot(d, cap.pole), radius = std::sqrt(dot(d, d));
        const double around = std::atan2(y, x), down = std::atan2(std::hypot(x, y), z);
        const Point radial = sum(scaled(std::cos(around), first), std::sin(around), second);
        FrontPlace place;
        place.axes[0] = sum(scaled(std::cos(down), radial), -std::sin(down), cap.pole);
        place.axes[1] = sum(scaled(std::sin(down), radial), std::cos(down), cap.pole);
        place.axes[2] = cross(place.axes[0], place.axes[1]);
        place.position = sum(sum(cap.centre, cap.sphere_radius * std::sin(cap.half_angle), radial),
                             cap.sphere_radius * std::cos(cap.half_angle), cap.pole);
        place.ahead = cap.sphere_radius * (down - cap.half_angle);
        place.above = radius - cap.sphere_radius;
        place.along = cap.sphere_radius * std::sin(cap.half_angle) * (around < 0 ? around + 2 * pi : around);
        return place;
    };
    const double radius = cap.sphere_radius * std::sin(cap.half_angle);
    const auto point_at = [cap, first, second, radius](double along) {
        const Point radial = sum(scaled(std::cos(along / radius), first), std::sin(along / radius), second);
        return sum(sum(cap.centre, radius, radial), cap.sphere_radius * std::cos(cap.half_angle), cap.pole);
    };
    return {locate, point_at, 2 * pi * radius, 2 * pi * radius, reach, "crack", {}};
}

Point uniform_growth(const CrackFront& front, const Point& point) {
    const FrontPlace place = front.locate(point);
    return growth(front, place, fade(front, place), point);
}

Point local_growth(const CrackFront& front, double along, double half_width, const Point& point) {
    const FrontPlace place = front.locate(point);
    double apart = std::abs(place.along - along);
    if (front.loop > 0) apart = std::min(apart, front.loop - apart);
    const double plateau = std::min(1.0, 2 * fade(front, place));
    return growth(front, place, plateau * std::max(0.0, 1 - apart / half_width), point);
}

}  // namespace cleave::geometry
