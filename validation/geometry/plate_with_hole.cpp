#include "validation/geometry/plate_with_hole.hpp"

#include "solver/input/read_values.hpp"
#include "validation/geometry/mesh_cache.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::geometry {

namespace {

struct Plate {
    double hole_radius, half_width, thickness;
    int layers = 1;
    bool quarter;
};

enum Tag { left = 1, right, front, back, bottom, top, hole, symmetry_x, symmetry_y };

const std::vector<std::string> full_names{"left", "right", "front", "back", "bottom", "top", "hole"};
const std::vector<std::string> quarter_names{"right", "back", "bottom", "top", "hole", "symmetry_x", "symmetry_y"};

int tag_of(const std::string& name) {
    const std::vector<std::string> names{"left", "right", "front", "back", "bottom", "top", "hole", "symmetry_x", "symmetry_y"};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) return static_cast<int>(i) + 1;
    throw std::logic_error("unknown surface " + name);
}

class PlateWithHole final : public Shape {
public:
    explicit PlateWithHole(const Plate& plate) : plate_(plate) {}

    Body mesh(double size, const std::filesystem::path& folder) const override {
        const std::string recipe = fmt::format("plate 6 {} {} {} {} {} size {}", plate_.hole_radius, plate_.half_width, plate_.thickness,
                                               plate_.layers, plate_.quarter, size);
        Body body;
        body.mesh_file = cached_mesh(folder, "plate_with_hole", recipe, [&] { build(size); });
        for (const std::string& name : surface_names()) body.surfaces[name] = tag_of(name);
        body.regions["body"] = 1;
        return body;
    }
    validation::Coordinates coordinates() const override {
        const Plate plate = plate_;
        return {{"x", [](const auto& p) { return p[0]; }},
                {"y", [](const auto& p) { return p[1]; }},
                {"z", [](const auto& p) { return p[2]; }},
                {"r", [](const auto& p) { return std::hypot(p[0], p[1]); }},
                {"a", [plate](const auto&) { return plate.hole_radius; }},
                {"t", [plate](const auto&) { return plate.thickness; }}};
    }
    double length(const std::string& key) const override {
        if (key == "hole_radius") return plate_.hole_radius;
        if (key == "half_width") return plate_.half_width;
        if (key == "thickness") return plate_.thickness;
        throw std::invalid_argument(fmt::format("one of hole_radius, half_width, thickness (not '{}')", key));
    }
    bool uniform_refinement() const override { return false; }
    std::vector<std::string> surface_names() const override { return plate_.quarter ? quarter_names : full_names; }

private:
    void build(double size) const {
        const double w = plate_.half_width;
        const int square = plate_.quarter ? gmsh::model::occ::addRectangle(0, 0, 0, w, w) : gmsh::model::occ::addRectangle(-w, -w, 0, 2 * w, 2 * w);
        const int disk = gmsh::model::occ::addDisk(0, 0, 0, plate_.hole_radius, plate_.hole_radius);
        gmsh::vectorpair cut, swept;
        std::vector<gmsh::vectorpair> map;
        gmsh::model::occ::cut({{2, square}}, {{2, disk}}, cut, map);
        gmsh::model::occ::extrude(cut, 0, 0, plate_.thickness, swept, {plate_.layers}, {}, false);
        gmsh::model::occ::synchronize();
        tag_surfaces();
        set_sizes(size);
    }

    void tag_surfaces() const {
        gmsh::vectorpair volumes, faces;
        gmsh::model::getEntities(volumes, 3);
        for (const auto& [dim, tag] : volumes) gmsh::model::addPhysicalGroup(3, {tag}, 1);
        gmsh::model::getEntities(faces, 2);
        std::map<int, std::vector<int>> groups;
        for (const auto& [dim, tag] : faces) groups[side_of(tag)].push_back(tag);
        for (const auto& [side, tags] : groups) gmsh::model::addPhysicalGroup(2, tags, side);
    }

    int side_of(int tag) const {
        double x0, y0, z0, x1, y1, z1;
        gmsh::model::getBoundingBox(2, tag, x0, y0, z0, x1, y1, z1);
        const double w = plate_.half_width, t = plate_.thickness, near = 1e-5 * plate_.hole_radius;
        const auto at = [near](double low, double high, double value) { return std::abs(low - value) < near && std::abs(high - value) < near; };
        if (at(z0, z1, 0)) return bottom;
        if (at(z0, z1, t)) return top;
        if (at(x0, x1, w)) return right;
        if (at(y0, y1, w)) return back;
        if (plate_.quarter && at(x0, x1, 0)) return symmetry_x;
        if (plate_.quarter && at(y0, y1, 0)) return symmetry_y;
        if (at(x0, x1, -w)) return left;
        if (at(y0, y1, -w)) return front;
        return hole;
    }

    void set_sizes(double size) const {
        const double a = plate_.hole_radius;
        const auto size_at = [a, size](double x, double y) {
            const double r = std::hypot(x, y);
            const double ring = r < 2 * a ? size / 3 + (size - size / 3) * std::max(0.0, r / a - 1) : size + 0.3 * std::max(0.0, r - 3 * a);
            // Stiff fibres squeeze the stress peak into a few hundredths of the radius beside the poles of the hole. The rim is a
            // polygon: facets of length c d at distance d change its curvature at the pole by c^2/4, hence the slow growth c.
            const double pole = std::min(std::hypot(x, std::abs(y) - a), std::hypot(std::abs(x) - a, y));
            return std::min(ring, size / 20 + 0.12 * pole);
        };
        gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
        gmsh::option::setNumber("Mesh.MeshSizeMin", 0);
        gmsh::option::setNumber("Mesh.MeshSizeMax", plate_.half_width);
        gmsh::model::mesh::setSizeCallback([size_at](int, int, double x, double y, double) { return size_at(x, y); });
    }

    Plate plate_;
};

}  // namespace

ShapeInfo plate_with_hole_info() {
    return {"plate_with_hole", "a square plate with a circular hole about z, or its quarter",
            {"hole_radius", "half_width", "thickness", "layers", "sector"},
            {"left", "right", "front", "back", "bottom", "top", "hole", "symmetry_x (quarter)", "symmetry_y (quarter)"},
            {"x", "y", "z", "r", "a", "t"}};
}

std::shared_ptr<const Shape> read_plate_with_hole(TableReader& geometry) {
    Plate plate{};
    plate.hole_radius = geometry.quantity("hole_radius", dimension::length);
    plate.half_width = geometry.quantity("half_width", dimension::length);
    plate.thickness = geometry.quantity("thickness", dimension::length);
    if (geometry.has("layers")) plate.layers = read_integer(geometry, "layers", 1, 1000);
    plate.quarter = geometry.choice_or("sector", {"full", "quarter"}, "full") == "quarter";
    if (!(plate.hole_radius > 0)) geometry.fail("hole_radius", "a positive length");
    if (!(plate.half_width > 3 * plate.hole_radius)) geometry.fail("half_width", "more than three hole radii");
    if (!(plate.thickness > 0)) geometry.fail("thickness", "a positive length");
    return std::make_shared<PlateWithHole>(plate);
}

}  // namespace cleave::geometry
