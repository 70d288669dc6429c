#include "validation/geometry/straight_cracks.hpp"

#include "validation/geometry/cracked_box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cleave::geometry {

namespace {

Point along(double s, const Point& axis) { return {s * axis[0], s * axis[1], s * axis[2]}; }

/// What both plates share; the crack runs from `from` to `to` along axes[0], m.
CrackedBox plate(const std::string& name, double thickness, const std::array<Point, 3>& axes, double from, double to) {
    CrackedBox box;
    box.name = name;
    box.low[2] = -thickness / 2;
    box.high[2] = thickness / 2;
    box.lengths["thickness"] = thickness;
    Point corner = along(from, axes[0]);
    corner[2] = -thickness;
    const Point across{0, 0, 2 * thickness};
    box.add_crack = [corner, u = along(to - from, axes[0]), across] { return add_parallelogram(corner, u, across); };
    return box;
}

}  // namespace

ShapeInfo through_crack_block_info() {
    return {"through_crack_block", "a plate about the origin with a straight crack through it", {"half_width", "half_height", "thickness", "crack_half_length", "crack_angle", "grading"},
            cracked_box_surfaces(), {"x", "y", "z", "a", "front_distance"}};
}

std::shared_ptr<const Shape> read_through_crack_block(TableReader& geometry) {
    const double w = positive_length(geometry, "half_width"), h = positive_length(geometry, "half_height"), t = positive_length(geometry, "thickness");
    const double a = positive_length(geometry, "crack_half_length"), angle = angle_within(geometry, "crack_angle", std::numbers::pi / 2);
    const std::array<Point, 3> axes = turned_axes(angle, 2);
    const double margin = std::min(w - a * std::abs(axes[0][0]), h - a * std::abs(axes[0][1]));
    if (!(margin > 0.1 * a)) geometry.fail("crack_half_length", "a crack inside the plate");
    CrackedBox box = plate("through_crack_block", t, axes, -a, a);
    box.low = {-w, -h, box.low[2]};
    box.high = {w, h, box.high[2]};
    box.lengths.insert({{"half_width", w}, {"half_height", h}, {"crack_half_length", a}});
    box.scale = "crack_half_length";
    const double reach = 0.8 * std::min(a, margin);
    const std::array<Point, 3> back{along(-1, axes[0]), axes[1], along(-1, axes[2])};
    box.fronts = {straight_front(along(a, axes[0]), axes, t, reach), straight_front(along(-a, axes[0]), back, t, reach)};
    box.grading = read_grading(geometry, 1.6);
    box.recipe = fmt::format("through 2 {} {} {} {} {}", w, h, t, a, angle);
    return make_cracked_box(std::move(box));
}

ShapeInfo edge_crack_block_info() {
    return {"edge_crack_block", "a plate with a straight crack through it from the side x = 0 on", {"width", "half_height", "thickness", "crack_length", "crack_angle", "grading"},
            cracked_box_surfaces(), {"x", "y", "z", "a", "front_distance"}};
}

std::shared_ptr<const Shape> read_edge_crack_block(TableReader& geometry) {
    const double w = positive_length(geometry, "width"), h = positive_length(geometry, "half_height"), t = positive_length(geometry, "thickness");
    const double a = positive_length(geometry, "crack_length"), angle = angle_within(geometry, "crack_angle", std::numbers::pi / 3);
    const std::array<Point, 3> axes = turned_axes(angle, 2);
    const double margin = std::min(w - a * axes[0][0], h - a * std::abs(axes[0][1]));
    if (!(margin > 0.1 * a)) geometry.fail("crack_length", "a crack that ends inside the plate");
    CrackedBox box = plate("edge_crack_block", t, axes, -a, a);  // cut off at the side
    box.low = {0, -h, box.low[2]};
    box.high = {w, h, box.high[2]};
    box.lengths.insert({{"width", w}, {"half_height", h}, {"crack_length", a}});
    box.scale = "crack_length";
    box.fronts = {straight_front(along(a, axes[0]), axes, t, 0.8 * std::min(a * axes[0][0], margin))};
    box.grading = read_grading(geometry, 1.6);
    box.recipe = fmt::format("edge 2 {} {} {} {} {}", w, h, t, a, angle);
    return make_cracked_box(std::move(box));
}

}  // namespace cleave::geometry
