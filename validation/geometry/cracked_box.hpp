#pragma once

#include "validation/geometry/crack_front.hpp"
#include "validation/geometry/shape.hpp"

#include <array>

namespace cleave::geometry {

/// A box with one crack: what the shapes with cracks differ in.
struct CrackedBox {
    std::string name;                       ///< of the shape
    std::array<double, 3> low{}, high{};    ///< m
    std::function<int()> add_crack;         ///< adds the crack to the current OCC model, larger than the box where it is open; its face
    bool inside = false;                    ///< the crack meets no side of the box
    std::vector<CrackFront> fronts;
    std::map<std::string, double> lengths;  ///< m: the shape's keys, crack_radius or crack_length among them
    std::string scale;                      ///< the length that elements grow by
    double grading = 0.8;                   ///< elements grow by grading sqrt(size / scale) per unit of distance from the front
    std::string recipe;                     ///< everything the mesh depends on but the size
    validation::Coordinates coordinates;    ///< besides x, y, z, a (the scale) and front_distance
};

/// The body: lips are doubled faces that share the surface `crack` (Gmsh's plugin Crack), vertices of the front are single, those where the
/// crack meets a side of the box are double. Elements have size `size` at the front.
std::shared_ptr<const Shape> make_cracked_box(CrackedBox box);

/// The surfaces of all cracked boxes: the six sides and `crack`.
const std::vector<std::string>& cracked_box_surfaces();

/// Unit vectors x, y, z turned by `angle` (rad) about one of them: 1 for y, 2 for z.
std::array<Point, 3> turned_axes(double angle, int about);

/// Moves OCC entities from the axes x, y, z about the origin to `axes`, turned by less than 180 degrees, about `origin`.
void move_to(const std::vector<std::pair<int, int>>& entities, const std::array<Point, 3>& axes, const Point& origin);
/// Adds the face of an ellipse, all of it whatever its arc. OCC; returns its tag.
int add_ellipse(const EllipseArc& ellipse);
/// Adds the parallelogram with corner `corner` and the sides u and v, m. OCC; returns its tag.
int add_parallelogram(const Point& corner, const Point& u, const Point& v);

/// Keys of the shapes' tables. Throw InputError: a length that is not positive, an angle (rad, 0 where absent) beyond +-limit.
double positive_length(TableReader& geometry, const std::string& key);
double angle_within(TableReader& geometry, const std::string& key, double limit);

/// The optional key `grading`, a positive number.
double read_grading(TableReader& geometry, double fallback);

}  // namespace cleave::geometry
