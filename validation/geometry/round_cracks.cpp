#include "validation/geometry/round_cracks.hpp"

#include "validation/geometry/cracked_box.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <cmath>
#include <numbers>

namespace cleave::geometry {

namespace {

constexpr double pi = std::numbers::pi;

/// A cube about the origin.
CrackedBox cube(const std::string& name, double half_width) {
    CrackedBox box;
    box.name = name;
    box.low = {-half_width, -half_width, -half_width};
    box.high = {half_width, half_width, half_width};
    box.lengths["half_width"] = half_width;
    return box;
}

/// Distance from the axis axes[2] through the origin.
double radius_about(const std::array<Point, 3>& axes, const Point& p) {
    const auto along = [&](std::size_t k) { return axes[k][0] * p[0] + axes[k][1] * p[1] + axes[k][2] * p[2]; };
    return std::hypot(along(0), along(1));
}

/// An elliptical crack at the centre of a cube, the whole of it inside.
CrackedBox centred_ellipse(CrackedBox box, const EllipseArc& ellipse) {
    box.inside = true;
    box.add_crack = [ellipse] { return add_ellipse(ellipse); };
    // 0.6 of the shorter half axis: the growth of a circle stays clear of its centre. An ellipse curves more at its ends.
    const double curvature_radius = ellipse.b * ellipse.b / ellipse.a;
    box.fronts = {elliptical_front(ellipse, 0.6 * curvature_radius)};
    box.coordinates["r"] = [axes = ellipse.axes](const Point& p) { return radius_about(axes, p); };
    return box;
}

/// The spherical face of a cap: of a piece cut off a ball, the face farthest along the pole.
int add_cap(const Cap& cap, const std::array<Point, 3>& axes) {
    namespace occ = gmsh::model::occ;
    const int piece = occ::addSphere(0, 0, 0, cap.sphere_radius, -1, pi / 2 - cap.half_angle, pi / 2);
    occ::synchronize();
    gmsh::vectorpair faces;
    gmsh::model::getBoundary({{3, piece}}, faces, false, false);
    occ::remove({{3, piece}});
    int top = 0;
    double highest = -INFINITY;
    for (const auto& [dimension, face] : faces) {
        double x = 0, y = 0, z = 0;
        occ::getCenterOfMass(2, face, x, y, z);
        if (z > highest) highest = z, top = face;
    }
    for (const auto& [dimension, face] : faces)
        if (face != top) occ::remove({{2, face}}, true);
    move_to({{2, top}}, axes, cap.centre);
    return top;
}

}  // namespace

ShapeInfo penny_crack_block_info() {
    return {"penny_crack_block", "a cube about the origin with a circular crack at its centre", {"half_width", "crack_radius", "crack_angle", "grading"},
            cracked_box_surfaces(), {"x", "y", "z", "r", "a", "front_distance"}};
}

std::shared_ptr<const Shape> read_penny_crack_block(TableReader& geometry) {
    CrackedBox box = cube("penny_crack_block", positive_length(geometry, "half_width"));
    const double radius = positive_length(geometry, "crack_radius"), angle = angle_within(geometry, "crack_angle", pi / 2);
    if (!(box.high[0] > 1.5 * radius)) geometry.fail("half_width", "more than one and a half crack radii");
    box.lengths["crack_radius"] = radius;
    box.scale = "crack_radius";
    box.grading = read_grading(geometry, 0.8);
    box.recipe = fmt::format("penny 4 {} {} {}", box.high[0], radius, angle);
    return make_cracked_box(centred_ellipse(std::move(box), {{}, turned_axes(angle, 1), radius, radius, 2 * pi}));
}

ShapeInfo elliptical_crack_block_info() {
    return {"elliptical_crack_block", "a cube about the origin with an elliptical crack at its centre, half axes along x and y",
            {"half_width", "half_axis_x", "half_axis_y", "crack_angle", "grading"}, cracked_box_surfaces(), {"x", "y", "z", "r", "a", "front_distance"}};
}

std::shared_ptr<const Shape> read_elliptical_crack_block(TableReader& geometry) {
    CrackedBox box = cube("elliptical_crack_block", positive_length(geometry, "half_width"));
    const double x = positive_length(geometry, "half_axis_x"), y = positive_length(geometry, "half_axis_y"), angle = angle_within(geometry, "crack_angle", pi / 2);
    if (!(box.high[0] > 1.5 * x && box.high[0] > 1.5 * y)) geometry.fail("half_width", "more than one and a half half axes");
    if (!(x >= y && x <= 3 * y)) geometry.fail("half_axis_x", "from one to three times half_axis_y");
    box.lengths["half_axis_x"] = x;
    box.lengths["half_axis_y"] = y;
    box.scale = "half_axis_y";
    box.grading = read_grading(geometry, 0.8);
    box.recipe = fmt::format("ellipse 3 {} {} {} {}", box.high[0], x, y, angle);
    return make_cracked_box(centred_ellipse(std::move(box), {{}, turned_axes(angle, 1), x, y, 2 * pi}));
}

ShapeInfo cap_crack_block_info() {
    return {"cap_crack_block", "a cube about the origin with a crack like a cap cut off a sphere, its front a circle about the origin",
            {"half_width", "crack_radius", "opening_angle", "crack_angle", "grading"}, cracked_box_surfaces(), {"x", "y", "z", "r", "a", "front_distance"}};
}

std::shared_ptr<const Shape> read_cap_crack_block(TableReader& geometry) {
    CrackedBox box = cube("cap_crack_block", positive_length(geometry, "half_width"));
    const double radius = positive_length(geometry, "crack_radius"), angle = angle_within(geometry, "crack_angle", pi / 2);
    const double opening = geometry.angle("opening_angle");
    if (!(opening >= pi / 36 && opening <= pi / 2)) geometry.fail("opening_angle", "an angle from 5 deg to 90 deg (from the pole to the front)");
    if (!(box.high[0] > 2 * radius)) geometry.fail("half_width", "more than two crack radii");
    box.lengths["crack_radius"] = radius;
    box.scale = "crack_radius";
    const std::array<Point, 3> axes = turned_axes(angle, 1);
    const double sphere = radius / std::sin(opening), depth = sphere * std::cos(opening);
    const Cap cap{{-depth * axes[2][0], -depth * axes[2][1], -depth * axes[2][2]}, axes[2], sphere, opening};
    box.inside = true;
    box.add_crack = [cap, axes] { return add_cap(cap, axes); };
    box.fronts = {cap_front(cap, 0.6 * radius)};
    box.coordinates["r"] = [axes](const Point& p) { return radius_about(axes, p); };
    box.grading = read_grading(geometry, 0.8);
    box.recipe = fmt::format("cap 3 {} {} {} {}", box.high[0], radius, opening, angle);
    return make_cracked_box(std::move(box));
}

ShapeInfo corner_crack_block_info() {
    return {"corner_crack_block", "a block whose edge along z at x = y = 0 has a quarter of a circular crack", {"width", "half_height", "crack_radius", "crack_angle", "grading"},
            cracked_box_surfaces(), {"x", "y", "z", "r", "a", "front_distance"}};
}

std::shared_ptr<const Shape> read_corner_crack_block(TableReader& geometry) {
    const double width = positive_length(geometry, "width"), height = positive_length(geometry, "half_height"), radius = positive_length(geometry, "crack_radius");
    const double angle = angle_within(geometry, "crack_angle", pi / 3);
    if (!(width > 1.5 * radius && height > 1.5 * radius)) geometry.fail("crack_radius", "less than two thirds of width and half_height");
    CrackedBox box;
    box.name = "corner_crack_block";
    box.low = {0, 0, -height};
    box.high = {width, width, height};
    box.lengths = {{"width", width}, {"half_height", height}, {"crack_radius", radius}};
    box.scale = "crack_radius";
    const EllipseArc disc{{}, turned_axes(angle, 1), radius, radius, pi / 2};
    box.add_crack = [disc] { return add_ellipse(disc); };
    box.fronts = {elliptical_front(disc, 0.6 * radius)};
    box.coordinates["r"] = [axes = disc.axes](const Point& p) { return radius_about(axes, p); };
    box.grading = read_grading(geometry, 0.8);
    box.recipe = fmt::format("corner 3 {} {} {} {}", width, height, radius, angle);
    return make_cracked_box(std::move(box));
}

}  // namespace cleave::geometry
