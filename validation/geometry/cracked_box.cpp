#include "validation/geometry/cracked_box.hpp"

#include "validation/geometry/box_sides.hpp"
#include "validation/geometry/mesh_cache.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::geometry {

namespace {

constexpr int crack_tag = 7, mouth_tag = 1;

class CrackedBoxShape final : public Shape {
public:
    explicit CrackedBoxShape(CrackedBox box) : box_(std::move(box)) {
        for (CrackFront& front : box_.fronts) front.box = {box_.low, box_.high};
    }

    Body mesh(double size, const std::filesystem::path& folder) const override {
        Body body;
        bool open = false;
        body.mesh_file = cached_mesh(folder, box_.name, fmt::format("{} grading {} size {}", box_.recipe, box_.grading, size), [&] { open = build(size); },
                                     [&] { open_crack(open); });
        for (std::size_t i = 0; i < cracked_box_surfaces().size(); ++i) body.surfaces[cracked_box_surfaces()[i]] = static_cast<int>(i) + 1;
        body.regions["body"] = 1;
        return body;
    }
    validation::Coordinates coordinates() const override {
        validation::Coordinates all = box_.coordinates;
        all["x"] = [](const Point& p) { return p[0]; };
        all["y"] = [](const Point& p) { return p[1]; };
        all["z"] = [](const Point& p) { return p[2]; };
        all["a"] = [a = scale()](const Point&) { return a; };
        all["front_distance"] = [fronts = box_.fronts](const Point& p) { return nearest_front(fronts, p); };
        return all;
    }
    double length(const std::string& key) const override {
        if (const auto found = box_.lengths.find(key); found != box_.lengths.end()) return found->second;
        std::vector<std::string> known;
        for (const auto& [name, value] : box_.lengths) known.push_back(name);
        throw std::invalid_argument(fmt::format("one of {} (not '{}')", fmt::join(known, ", "), key));
    }
    std::vector<CrackFront> crack_fronts() const override { return box_.fronts; }
    bool uniform_refinement() const override { return false; }
    std::vector<std::string> surface_names() const override { return cracked_box_surfaces(); }

private:
    double scale() const { return box_.lengths.at(box_.scale); }

    static double nearest_front(const std::vector<CrackFront>& fronts, const Point& p) {
        double nearest = INFINITY;
        for (const CrackFront& front : fronts) nearest = std::min(nearest, distance(front.locate(p)));
        return nearest;
    }

    /// True where the crack meets a side.
    bool build(double size) const {
        namespace occ = gmsh::model::occ;
        std::array<double, 3> extent{};
        for (std::size_t k = 0; k < 3; ++k) extent[k] = box_.high[k] - box_.low[k];
        const int body = occ::addBox(box_.low[0], box_.low[1], box_.low[2], extent[0], extent[1], extent[2]);
        gmsh::vectorpair crack{{2, box_.add_crack()}}, all;
        std::vector<gmsh::vectorpair> pieces;  // of the box, then of the crack
        if (!box_.inside) {
            gmsh::vectorpair inside;
            occ::intersect(crack, {{3, body}}, inside, pieces, -1, true, false);
            crack = inside;
        }
        occ::fragment({{3, body}}, crack, all, pieces);
        occ::synchronize();
        set_sizes(size);
        return tag(pieces);
    }

    bool tag(const std::vector<gmsh::vectorpair>& pieces) const {
        std::vector<int> volumes, cracks;
        for (const auto& [dimension, piece] : pieces[0]) volumes.push_back(piece);
        for (std::size_t i = 1; i < pieces.size(); ++i)
            for (const auto& [dimension, piece] : pieces[i]) cracks.push_back(piece);
        gmsh::model::addPhysicalGroup(3, volumes, 1);
        gmsh::model::addPhysicalGroup(2, cracks, crack_tag);
        std::map<int, std::vector<int>> sides;  // a side may be cut into several faces
        gmsh::vectorpair faces;
        gmsh::model::getEntities(faces, 2);
        for (const auto& [dimension, face] : faces)
            if (std::find(cracks.begin(), cracks.end(), face) == cracks.end()) sides[box_side_of(face, box_.low, box_.high)].push_back(face);
        for (const auto& [side, of_side] : sides) gmsh::model::addPhysicalGroup(2, of_side, side);
        const std::vector<int> mouth = mouth_of(cracks);
        if (!mouth.empty()) gmsh::model::addPhysicalGroup(1, mouth, mouth_tag);
        return !mouth.empty();
    }

    /// The crack's curves that lie on a side of the box.
    std::vector<int> mouth_of(const std::vector<int>& cracks) const {
        std::vector<int> mouth;
        for (const int crack : cracks) {
            gmsh::vectorpair curves;
            gmsh::model::getBoundary({{2, crack}}, curves, false, false);
            for (const auto& [dimension, curve] : curves) {
                std::array<double, 3> centre{};  // on a side only where all of the curve is; bounding boxes are too wide by 1e-7 m
                gmsh::model::occ::getCenterOfMass(1, curve, centre[0], centre[1], centre[2]);
                for (std::size_t k = 0; k < 3; ++k) {
                    const double near = 1e-6 * (box_.high[k] - box_.low[k]);
                    if (centre[k] < box_.low[k] + near || centre[k] > box_.high[k] - near) mouth.push_back(curve);
                }
            }
        }
        return mouth;
    }

    void set_sizes(double size) const {
        const double growth = box_.grading * std::sqrt(size / scale());
        double largest = 0;
        for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, box_.high[k] - box_.low[k]);
        gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
        gmsh::option::setNumber("Mesh.MeshSizeMin", 0);
        gmsh::option::setNumber("Mesh.MeshSizeMax", largest / 2);
        gmsh::model::mesh::setSizeCallback([fronts = box_.fronts, size, growth](int, int, double x, double y, double z) {
            return size + growth * nearest_front(fronts, {x, y, z});
        });
    }

    /// Doubles the faces of the meshed crack, and its vertices but for those of the front.
    static void open_crack(bool has_mouth) {
        gmsh::plugin::setNumber("Crack", "Dimension", 2);
        gmsh::plugin::setNumber("Crack", "PhysicalGroup", crack_tag);
        gmsh::plugin::setNumber("Crack", "OpenBoundaryPhysicalGroup", has_mouth ? mouth_tag : 0);
        gmsh::plugin::run("Crack");
    }

    CrackedBox box_;
};

}  // namespace

std::shared_ptr<const Shape> make_cracked_box(CrackedBox box) { return std::make_shared<CrackedBoxShape>(std::move(box)); }

const std::vector<std::string>& cracked_box_surfaces() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list = box_side_names();
        list.emplace_back("crack");
        return list;
    }();
    return names;
}

std::array<Point, 3> turned_axes(double angle, int about) {
    const double c = std::cos(angle), s = std::sin(angle);
    if (about == 1) return {Point{c, 0, -s}, Point{0, 1, 0}, Point{s, 0, c}};
    return {Point{c, s, 0}, Point{-s, c, 0}, Point{0, 0, 1}};
}

void move_to(const gmsh::vectorpair& entities, const std::array<Point, 3>& axes, const Point& origin) {
    // Not by an affine map, which would make splines of circles. Rotation by `angle` about the axis in the skew part of its matrix.
    const Point axis{axes[1][2] - axes[2][1], axes[2][0] - axes[0][2], axes[0][1] - axes[1][0]};
    const double sine = std::hypot(axis[0], axis[1], axis[2]) / 2, cosine = (axes[0][0] + axes[1][1] + axes[2][2] - 1) / 2;
    if (sine > 0) gmsh::model::occ::rotate(entities, 0, 0, 0, axis[0], axis[1], axis[2], std::atan2(sine, cosine));
    if (origin != Point{}) gmsh::model::occ::translate(entities, origin[0], origin[1], origin[2]);
}

int add_ellipse(const EllipseArc& ellipse) {
    const int disk = gmsh::model::occ::addDisk(0, 0, 0, ellipse.a, ellipse.b);
    move_to({{2, disk}}, ellipse.axes, ellipse.centre);
    return disk;
}

int add_parallelogram(const Point& corner, const Point& u, const Point& v) {
    namespace occ = gmsh::model::occ;
    const auto point = [&](double s, double t) { return occ::addPoint(corner[0] + s * u[0] + t * v[0], corner[1] + s * u[1] + t * v[1], corner[2] + s * u[2] + t * v[2]); };
    const std::array<int, 4> p{point(0, 0), point(1, 0), point(1, 1), point(0, 1)};
    std::vector<int> lines;
    for (std::size_t k = 0; k < 4; ++k) lines.push_back(occ::addLine(p[k], p[(k + 1) % 4]));
    return occ::addPlaneSurface({occ::addCurveLoop(lines)});
}

double positive_length(TableReader& geometry, const std::string& key) {
    const double value = geometry.quantity(key, dimension::length);
    if (!(value > 0)) geometry.fail(key, "a positive length");
    return value;
}

double angle_within(TableReader& geometry, const std::string& key, double limit) {
    const double angle = geometry.angle_or(key, 0);
    if (!(std::abs(angle) <= limit)) geometry.fail(key, fmt::format("an angle from {0:g} deg to {1:g} deg", -limit / std::numbers::pi * 180, limit / std::numbers::pi * 180));
    return angle;
}

double read_grading(TableReader& geometry, double fallback) {
    const double grading = geometry.number_or("grading", fallback);
    if (!(grading > 0 && grading <= 4)) geometry.fail("grading", "a number from 0 to 4: elements grow by grading sqrt(size / a) per distance from the front");
    return grading;
}

}  // namespace cleave::geometry
