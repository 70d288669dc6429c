#include "validation/geometry/penny_octant.hpp"

#include "validation/geometry/mesh_cache.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::geometry {

namespace {

enum Side { left = 1, right, front, back, top, ligament, lips, core };
const std::vector<std::string> names{"left", "right", "front", "back", "top", "ligament", "lips", "core"};

struct Octant {
    double half_width, crack_radius, load_radius;

    double distance_to_front(double x, double y, double z) const { return std::hypot(std::hypot(x, y) - crack_radius, z); }
    double distance_to_core(double x, double y, double z) const {
        return std::hypot(std::max(std::hypot(x, y) - load_radius, 0.0), z);
    }
};

class PennyOctant final : public Shape {
public:
    explicit PennyOctant(const Octant& octant) : octant_(octant) {}

    Body mesh(double size, const std::filesystem::path& folder) const override {
        const auto& [w, a, c] = octant_;
        Body body;
        const std::string recipe = fmt::format("penny octant 1 {} {} {} size {}", w, a, c, size);
        body.mesh_file = cached_mesh(folder, "penny_octant", recipe, [&] { build(size); });
        for (std::size_t i = 0; i < names.size(); ++i) body.surfaces[names[i]] = static_cast<int>(i) + 1;
        body.regions["body"] = 1;
        return body;
    }
    validation::Coordinates coordinates() const override {
        const Octant octant = octant_;
        return {{"x", [](const auto& p) { return p[0]; }},
                {"y", [](const auto& p) { return p[1]; }},
                {"z", [](const auto& p) { return p[2]; }},
                {"r", [](const auto& p) { return std::hypot(p[0], p[1]); }},
                {"a", [a = octant.crack_radius](const auto&) { return a; }},
                {"front_distance", [octant](const auto& p) { return octant.distance_to_front(p[0], p[1], p[2]); }}};
    }
    double length(const std::string& key) const override {
        if (key == "crack_radius") return octant_.crack_radius;
        if (key == "half_width") return octant_.half_width;
        if (key == "load_radius") return octant_.load_radius;
        throw std::invalid_argument(fmt::format("one of crack_radius, half_width, load_radius (not '{}')", key));
    }
    /// A quarter of the crack belongs to two octants, one on each lip: its area counts half.
    std::vector<CrackFront> crack_fronts() const override {
        const auto& [w, a, c] = octant_;
        CrackFront front = elliptical_front({{}, {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}}, a, a, std::numbers::pi / 2}, 0.6 * a);
        front.lips = names[lips - 1];
        front.box = {Point{0, 0, 0}, Point{w, w, w}};
        return {front};
    }
    bool uniform_refinement() const override { return false; }
    std::vector<std::string> surface_names() const override { return names; }

private:
    void build(double size) const {
        const double w = octant_.half_width;
        const int box = gmsh::model::occ::addBox(0, 0, 0, w, w, w);
        const int crack = gmsh::model::occ::addDisk(0, 0, 0, octant_.crack_radius, octant_.crack_radius);
        const int load = gmsh::model::occ::addDisk(0, 0, 0, octant_.load_radius, octant_.load_radius);
        gmsh::vectorpair quarters, out;
        std::vector<gmsh::vectorpair> pieces;
        gmsh::model::occ::intersect({{2, crack}, {2, load}}, {{3, box}}, quarters, pieces, -1, true, false);
        gmsh::model::occ::fragment({{3, box}}, quarters, out, pieces);
        gmsh::model::occ::synchronize();
        gmsh::model::addPhysicalGroup(3, {pieces.front().front().second}, 1);
        gmsh::vectorpair faces;
        gmsh::model::getEntities(faces, 2);
        for (const auto& [dim, tag] : faces) gmsh::model::addPhysicalGroup(2, {tag}, side_of(tag));
        set_sizes(size);
    }

    int side_of(int face) const {
        std::array<double, 3> low, high;
        gmsh::model::getBoundingBox(2, face, low[0], low[1], low[2], high[0], high[1], high[2]);
        const double w = octant_.half_width, near = 1e-4 * octant_.load_radius;
        const auto flat = [&](int axis, double at) { return std::abs(low[axis] - at) < near && std::abs(high[axis] - at) < near; };
        if (flat(0, 0)) return left;
        if (flat(0, w)) return right;
        if (flat(1, 0)) return front;
        if (flat(1, w)) return back;
        if (flat(2, w)) return top;
        if (high[0] > octant_.crack_radius + near) return ligament;
        return high[0] > octant_.load_radius + near ? lips : core;
    }

    void set_sizes(double size) const {
        const Octant octant = octant_;
        const double growth = 0.8 * std::sqrt(size / octant.crack_radius);
        gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
        gmsh::option::setNumber("Mesh.MeshSizeMin", 0);
        gmsh::option::setNumber("Mesh.MeshSizeMax", octant.half_width);
        gmsh::model::mesh::setSizeCallback([octant, size, growth](int, int, double x, double y, double z) {
            return std::min(size + growth * octant.distance_to_front(x, y, z),
                            0.5 * octant.load_radius + growth * octant.distance_to_core(x, y, z));
        });
    }

    Octant octant_;
};

}  // namespace

ShapeInfo penny_octant_info() {
    return {"penny_octant", "an eighth of a cube with a circular crack at its centre, loaded on a disc inside the crack or from afar",
            {"half_width", "crack_radius", "load_radius"}, names, {"x", "y", "z", "r", "a", "front_distance"}};
}

std::shared_ptr<const Shape> read_penny_octant(TableReader& geometry) {
    Octant octant{};
    octant.half_width = geometry.quantity("half_width", dimension::length);
    octant.crack_radius = geometry.quantity("crack_radius", dimension::length);
    octant.load_radius = geometry.quantity("load_radius", dimension::length);
    if (!(octant.load_radius > 0)) geometry.fail("load_radius", "a positive length");
    if (!(octant.crack_radius > 2.5 * octant.load_radius)) geometry.fail("crack_radius", "more than two and a half load radii");
    if (!(octant.half_width > 1.6 * octant.crack_radius)) geometry.fail("half_width", "more than 1.6 crack radii");
    return std::make_shared<PennyOctant>(octant);
}

}  // namespace cleave::geometry
