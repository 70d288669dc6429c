#include "validation/geometry/block.hpp"

#include "validation/geometry/box_sides.hpp"
#include "validation/geometry/mesh_cache.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleave::geometry {

namespace {

class Block final : public Shape {
public:
    explicit Block(const std::array<double, 3>& extent) : extent_(extent) {}

    Body mesh(double size, const std::filesystem::path& folder) const override {
        const std::string recipe = fmt::format("block 1 {} {} {} size {}", extent_[0], extent_[1], extent_[2], size);
        Body body;
        body.mesh_file = cached_mesh(folder, "block", recipe, [&] { build(size); });
        for (std::size_t i = 0; i < box_side_names().size(); ++i) body.surfaces[box_side_names()[i]] = static_cast<int>(i) + 1;
        body.regions["body"] = 1;
        return body;
    }
    validation::Coordinates coordinates() const override {
        const auto extent = extent_;
        return {{"x", [](const auto& p) { return p[0]; }},
                {"y", [](const auto& p) { return p[1]; }},
                {"z", [](const auto& p) { return p[2]; }},
                {"depth", [extent](const auto& p) {  // distance to the nearest side
                     double depth = INFINITY;
                     for (std::size_t k = 0; k < 3; ++k) depth = std::min({depth, p[k], extent[k] - p[k]});
                     return depth;
                 }}};
    }
    double length(const std::string& key) const override {
        if (key == "extent") return *std::max_element(extent_.begin(), extent_.end());
        throw std::invalid_argument(fmt::format("one of extent (not '{}')", key));
    }
    bool uniform_refinement() const override { return true; }
    double expected_tets(double size) const override { return tets_of_box(extent_, size); }
    std::vector<std::string> surface_names() const override { return box_side_names(); }

private:
    void build(double size) const {
        gmsh::model::occ::addBox(0, 0, 0, extent_[0], extent_[1], extent_[2]);
        gmsh::model::occ::synchronize();
        gmsh::model::addPhysicalGroup(3, {1}, 1);
        gmsh::vectorpair faces;
        gmsh::model::getEntities(faces, 2);
        for (const auto& [dim, tag] : faces) gmsh::model::addPhysicalGroup(2, {tag}, box_side_of(tag, {0, 0, 0}, extent_));
        gmsh::option::setNumber("Mesh.MeshSizeMin", size);
        gmsh::option::setNumber("Mesh.MeshSizeMax", size);
    }

    std::array<double, 3> extent_;
};

}  // namespace

ShapeInfo block_info() { return {"block", "a box from the origin to extent", {"extent"}, box_side_names(), {"x", "y", "z", "depth"}}; }

std::shared_ptr<const Shape> read_block(TableReader& geometry) {
    const std::array<double, 3> extent = geometry.vector("extent", dimension::length);
    for (const double length : extent)
        if (!(length > 0)) geometry.fail("extent", "three positive lengths");
    return std::make_shared<Block>(extent);
}

}  // namespace cleave::geometry
