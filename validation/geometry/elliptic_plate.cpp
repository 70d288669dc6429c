#include "validation/geometry/elliptic_plate.hpp"

#include "validation/geometry/mesh_cache.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <cmath>
#include <stdexcept>

namespace cleave::geometry {

namespace {

struct Plate {
    std::array<double, 2> inner, outer;  // semi-axes along x and y
    double thickness;
};

enum Tag { inner_side = 1, outer_lower, outer_upper, bottom, top, symmetry_x, symmetry_y };
const std::vector<std::string> names{"inner", "outer_lower", "outer_upper", "bottom", "top", "symmetry_x", "symmetry_y"};

class EllipticPlate final : public Shape {
public:
    explicit EllipticPlate(const Plate& plate) : plate_(plate) {}

    Body mesh(double size, const std::filesystem::path& folder) const override {
        const auto& [inner, outer, thickness] = plate_;
        const std::string recipe =
            fmt::format("elliptic plate 1 {} {} {} {} {} size {}", inner[0], inner[1], outer[0], outer[1], thickness, size);
        Body body;
        body.mesh_file = cached_mesh(folder, "elliptic_plate", recipe, [&] { build(size); });
        for (std::size_t i = 0; i < names.size(); ++i) body.surfaces[names[i]] = static_cast<int>(i) + 1;
        body.regions["body"] = 1;
        return body;
    }
    validation::Coordinates coordinates() const override {
        return {{"x", [](const auto& p) { return p[0]; }},
                {"y", [](const auto& p) { return p[1]; }},
                {"z", [](const auto& p) { return p[2]; }},
                {"t", [t = plate_.thickness](const auto&) { return t; }}};
    }
    double length(const std::string& key) const override {
        if (key == "thickness") return plate_.thickness;
        throw std::invalid_argument(fmt::format("one of thickness (not '{}')", key));
    }
    bool uniform_refinement() const override { return false; }
    std::vector<std::string> surface_names() const override { return names; }

private:
    void build(double size) const {
        const double half = plate_.thickness / 2, wide = 2 * std::max(plate_.outer[0], plate_.outer[1]);
        gmsh::vectorpair ring, quarter, lower, upper;
        std::vector<gmsh::vectorpair> map;
        gmsh::model::occ::cut({{2, disk(plate_.outer)}}, {{2, disk(plate_.inner)}}, ring, map);
        gmsh::model::occ::intersect(ring, {{2, gmsh::model::occ::addRectangle(0, 0, 0, wide, wide)}}, quarter, map);
        gmsh::model::occ::extrude(quarter, 0, 0, half, lower);
        const gmsh::vectorpair middle{lower.front()};  // the far end of the sweep comes first
        gmsh::model::occ::extrude(middle, 0, 0, half, upper);
        gmsh::model::occ::synchronize();
        tag_entities();
        set_sizes(size);
    }

    static int disk(const std::array<double, 2>& axes) {
        if (axes[0] < axes[1]) throw std::logic_error("OCC wants the longer semi-axis first");
        return gmsh::model::occ::addDisk(0, 0, 0, axes[0], axes[1]);
    }

    void tag_entities() const {
        gmsh::vectorpair volumes, faces;
        gmsh::model::getEntities(volumes, 3);
        std::vector<int> body;
        for (const auto& [dim, tag] : volumes) body.push_back(tag);
        gmsh::model::addPhysicalGroup(3, body, 1);
        gmsh::model::getEntities(faces, 2);
        std::map<int, std::vector<int>> groups;
        for (const auto& [dim, tag] : faces)
            if (const int side = side_of(tag)) groups[side].push_back(tag);
        for (const auto& [side, tags] : groups) gmsh::model::addPhysicalGroup(2, tags, side);
    }

    /// 0 for the plane between the halves.
    int side_of(int tag) const {
        double x0, y0, z0, x1, y1, z1;
        gmsh::model::getBoundingBox(2, tag, x0, y0, z0, x1, y1, z1);
        const double near = 1e-4 * plate_.thickness;
        const auto at = [near](double low, double high, double value) { return std::abs(low - value) < near && std::abs(high - value) < near; };
        if (at(z0, z1, 0)) return bottom;
        if (at(z0, z1, plate_.thickness)) return top;
        if (at(z0, z1, plate_.thickness / 2)) return 0;
        if (at(x0, x1, 0)) return symmetry_x;
        if (at(y0, y1, 0)) return symmetry_y;
        if (x1 < plate_.outer[0] - near) return inner_side;
        return z0 < plate_.thickness / 4 ? outer_lower : outer_upper;
    }

    /// The stress peaks at the end of the inner ellipse on the x axis, where it bends most: facets there are short (see plate_with_hole.cpp).
    void set_sizes(double size) const {
        const double end = plate_.inner[0];
        gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
        gmsh::option::setNumber("Mesh.MeshSizeMin", 0);
        gmsh::option::setNumber("Mesh.MeshSizeMax", 10 * size);
        gmsh::model::mesh::setSizeCallback([size, end](int, int, double x, double y, double) {
            return std::min(size, size / 8 + 0.2 * std::hypot(x - end, y));
        });
    }

    Plate plate_;
};

std::array<double, 2> read_axes(TableReader& geometry, const std::string& key) {
    const std::array<double, 3> axes = geometry.vector(key, dimension::length);
    if (!(axes[0] >= axes[1] && axes[1] > 0)) geometry.fail(key, "the semi-axes along x and y, the first not shorter, and the height 0");
    return {axes[0], axes[1]};
}

}  // namespace

ShapeInfo elliptic_plate_info() {
    return {"elliptic_plate", "a quarter of a plate between two ellipses (NAFEMS LE1, LE10)", {"inner", "outer", "thickness"}, names, {"x", "y", "z", "t"}};
}

std::shared_ptr<const Shape> read_elliptic_plate(TableReader& geometry) {
    Plate plate{read_axes(geometry, "inner"), read_axes(geometry, "outer"), geometry.quantity("thickness", dimension::length)};
    if (!(plate.outer[0] > plate.inner[0] && plate.outer[1] > plate.inner[1])) geometry.fail("outer", "an ellipse around the inner one");
    if (!(plate.thickness > 0)) geometry.fail("thickness", "a positive length");
    return std::make_shared<EllipticPlate>(plate);
}

}  // namespace cleave::geometry
