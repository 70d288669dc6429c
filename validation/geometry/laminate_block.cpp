#include "validation/geometry/laminate_block.hpp"

#include "validation/geometry/box_sides.hpp"
#include "validation/geometry/mesh_cache.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace cleave::geometry {

namespace {

class LaminateBlock final : public Shape {
public:
    LaminateBlock(const std::array<double, 3>& extent, double interface) : extent_(extent), interface_(interface) {}

    Body mesh(double size, const std::filesystem::path& folder) const override {
        const std::string recipe = fmt::format("laminate 1 {} {} {} at {} size {}", extent_[0], extent_[1], extent_[2], interface_, size);
        Body body;
        body.mesh_file = cached_mesh(folder, "laminate_block", recipe, [&] { build(size); });
        for (std::size_t i = 0; i < box_side_names().size(); ++i) body.surfaces[box_side_names()[i]] = static_cast<int>(i) + 1;
        body.regions = {{"lower", 1}, {"upper", 2}};
        return body;
    }
    validation::Coordinates coordinates() const override {
        return {{"x", [](const auto& p) { return p[0]; }},
                {"y", [](const auto& p) { return p[1]; }},
                {"z", [](const auto& p) { return p[2]; }},
                {"interface", [z = interface_](const auto&) { return z; }}};
    }
    double length(const std::string& key) const override {
        if (key == "extent") return *std::max_element(extent_.begin(), extent_.end());
        if (key == "interface") return interface_;
        throw std::invalid_argument(fmt::format("one of extent, interface (not '{}')", key));
    }
    bool uniform_refinement() const override { return true; }
    double expected_tets(double size) const override { return tets_of_box(extent_, size); }
    std::vector<std::string> surface_names() const override { return box_side_names(); }

private:
    void build(double size) const {
        const int lower = gmsh::model::occ::addBox(0, 0, 0, extent_[0], extent_[1], interface_);
        const int upper = gmsh::model::occ::addBox(0, 0, interface_, extent_[0], extent_[1], extent_[2] - interface_);
        gmsh::vectorpair out;
        std::vector<gmsh::vectorpair> pieces;
        gmsh::model::occ::fragment({{3, lower}}, {{3, upper}}, out, pieces);
        gmsh::model::occ::synchronize();
        gmsh::model::addPhysicalGroup(3, {pieces[0].front().second}, 1);
        gmsh::model::addPhysicalGroup(3, {pieces[1].front().second}, 2);
        gmsh::vectorpair faces;
        gmsh::model::getEntities(faces, 2);
        std::map<int, std::vector<int>> sides;
        for (const auto& [dim, tag] : faces)
            if (const int side = box_side_of(tag, {0, 0, 0}, extent_)) sides[side].push_back(tag);
        for (const auto& [side, tags] : sides) gmsh::model::addPhysicalGroup(2, tags, side);
        gmsh::option::setNumber("Mesh.MeshSizeMin", size);
        gmsh::option::setNumber("Mesh.MeshSizeMax", size);
    }

    std::array<double, 3> extent_;
    double interface_;
};

}  // namespace

ShapeInfo laminate_block_info() {
    return {"laminate_block", "a box of two layers, regions lower and upper", {"extent", "interface"}, box_side_names(), {"x", "y", "z", "interface"}};
}

std::shared_ptr<const Shape> read_laminate_block(TableReader& geometry) {
    const std::array<double, 3> extent = geometry.vector("extent", dimension::length);
    const double interface = geometry.quantity("interface", dimension::length);
    for (const double length : extent)
        if (!(length > 0)) geometry.fail("extent", "three positive lengths");
    if (!(interface > 0 && interface < extent[2])) geometry.fail("interface", "a height inside the box");
    return std::make_shared<LaminateBlock>(extent, interface);
}

}  // namespace cleave::geometry
