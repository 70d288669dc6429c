#include "validation/geometry/penny_crack_block.hpp"

#include "validation/geometry/box_sides.hpp"
#include "validation/geometry/mesh_cache.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::geometry {

namespace {

const std::vector<std::string> names{"left", "right", "front", "back", "bottom", "top", "crack"};
constexpr int crack_tag = 7;

struct Penny {
    double half_width, crack_radius, crack_angle;

    /// Distance from the axis of the crack, and height above its plane.
    std::pair<double, double> radius_and_height(double x, double y, double z) const {
        const double c = std::cos(crack_angle), s = std::sin(crack_angle);
        return {std::hypot(c * x - s * z, y), s * x + c * z};
    }
    double distance_to_front(double x, double y, double z) const {
        const auto [r, height] = radius_and_height(x, y, z);
        return std::hypot(r - crack_radius, height);
    }
};

class PennyCrackBlock final : public Shape {
public:
    explicit PennyCrackBlock(const Penny& penny) : penny_(penny) {}

    Body mesh(double size, const std::filesystem::path& folder) const override {
        const std::string recipe =
            fmt::format("penny 1 {} {} {} size {}", penny_.half_width, penny_.crack_radius, penny_.crack_angle, size);
        Body body;
        body.mesh_file = cached_mesh(folder, "penny_crack_block", recipe, [&] { build(size); }, open_crack);
        for (std::size_t i = 0; i < names.size(); ++i) body.surfaces[names[i]] = static_cast<int>(i) + 1;
        body.regions["body"] = 1;
        return body;
    }
    validation::Coordinates coordinates() const override {
        const Penny penny = penny_;
        return {{"x", [](const auto& p) { return p[0]; }},
                {"y", [](const auto& p) { return p[1]; }},
                {"z", [](const auto& p) { return p[2]; }},
                {"r", [penny](const auto& p) { return penny.radius_and_height(p[0], p[1], p[2]).first; }},
                {"a", [penny](const auto&) { return penny.crack_radius; }},
                {"front_distance", [penny](const auto& p) { return penny.distance_to_front(p[0], p[1], p[2]); }}};
    }
    double length(const std::string& key) const override {
        if (key == "crack_radius") return penny_.crack_radius;
        if (key == "half_width") return penny_.half_width;
        throw std::invalid_argument(fmt::format("one of crack_radius, half_width (not '{}')", key));
    }
    /// Radial growth of the whole front, fading to zero at 0.6 radii from it; the difference step is 1e-3 of the radius.
    std::optional<CrackGrowth> crack_growth() const override {
        const Penny penny = penny_;
        const double c = std::cos(penny.crack_angle), s = std::sin(penny.crack_angle), a = penny.crack_radius;
        const auto growth = [penny, c, s, a](const validation::Point& p) -> validation::Point {
            const double share = 1 - penny.distance_to_front(p[0], p[1], p[2]) / (0.6 * a);
            if (share <= 0) return {0, 0, 0};
            const double along = c * p[0] - s * p[2], r = std::hypot(along, p[1]);  // in the plane of the crack
            return {share * c * along / r, share * p[1] / r, -share * s * along / r};
        };
        return CrackGrowth{"crack", growth, 2 * std::numbers::pi * a, 1e-3 * a, {s, 0, c}};
    }
    bool uniform_refinement() const override { return false; }
    std::vector<std::string> surface_names() const override { return names; }

private:
    void build(double size) const {
        const double w = penny_.half_width, a = penny_.crack_radius;
        const int box = gmsh::model::occ::addBox(-w, -w, -w, 2 * w, 2 * w, 2 * w);
        const int disk = gmsh::model::occ::addDisk(0, 0, 0, a, a);
        if (penny_.crack_angle != 0) gmsh::model::occ::rotate({{2, disk}}, 0, 0, 0, 0, 1, 0, penny_.crack_angle);
        gmsh::vectorpair out;
        std::vector<gmsh::vectorpair> pieces;  // of the box, then of the disk
        gmsh::model::occ::fragment({{3, box}}, {{2, disk}}, out, pieces);
        gmsh::model::occ::synchronize();
        tag(pieces[0].front().second, pieces[1].front().second);
        set_sizes(size);
    }

    void tag(int volume, int crack) const {
        gmsh::model::addPhysicalGroup(3, {volume}, 1);
        gmsh::model::addPhysicalGroup(2, {crack}, crack_tag);
        const double w = penny_.half_width;
        gmsh::vectorpair faces;
        gmsh::model::getEntities(faces, 2);
        for (const auto& [dim, face] : faces)
            if (face != crack) gmsh::model::addPhysicalGroup(2, {face}, box_side_of(face, {-w, -w, -w}, {w, w, w}));
    }

    void set_sizes(double size) const {
        const Penny penny = penny_;
        const double growth = 0.8 * std::sqrt(size / penny.crack_radius);
        gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
        gmsh::option::setNumber("Mesh.MeshSizeMin", 0);
        gmsh::option::setNumber("Mesh.MeshSizeMax", penny.half_width);
        gmsh::model::mesh::setSizeCallback([penny, size, growth](int, int, double x, double y, double z) {
            return size + growth * penny.distance_to_front(x, y, z);
        });
    }

    /// Doubles the faces of the meshed crack, and its vertices but for those of the front.
    static void open_crack() {
        gmsh::plugin::setNumber("Crack", "Dimension", 2);
        gmsh::plugin::setNumber("Crack", "PhysicalGroup", crack_tag);
        gmsh::plugin::run("Crack");
    }

    Penny penny_;
};

}  // namespace

ShapeInfo penny_crack_block_info() {
    return {"penny_crack_block", "a cube about the origin with a circular crack at its centre", {"half_width", "crack_radius", "crack_angle"},
            names, {"x", "y", "z", "r", "a", "front_distance"}};
}

std::shared_ptr<const Shape> read_penny_crack_block(TableReader& geometry) {
    Penny penny{};
    penny.half_width = geometry.quantity("half_width", dimension::length);
    penny.crack_radius = geometry.quantity("crack_radius", dimension::length);
    penny.crack_angle = geometry.angle_or("crack_angle", 0);
    if (!(penny.crack_radius > 0)) geometry.fail("crack_radius", "a positive length");
    if (!(penny.half_width > 1.5 * penny.crack_radius)) geometry.fail("half_width", "more than one and a half crack radii");
    if (!(std::abs(penny.crack_angle) <= std::numbers::pi / 2)) geometry.fail("crack_angle", "an angle from -90 deg to 90 deg");
    return std::make_shared<PennyCrackBlock>(penny);
}

}  // namespace cleave::geometry
