#include "validation/geometry/layered_strip.hpp"

#include "solver/input/read_values.hpp"
#include "validation/geometry/mesh_cache.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace cleave::geometry {

namespace {

struct Strip {
    double length, width, support;
    std::vector<double> thicknesses;
    double height() const { return std::accumulate(thicknesses.begin(), thicknesses.end(), 0.0); }
};

enum Tag { left = 1, right, front, back, bottom_outer, bottom_inner, top };
const std::vector<std::string> names{"left", "right", "front", "back", "bottom_outer", "bottom_inner", "top"};

class LayeredStrip final : public Shape {
public:
    explicit LayeredStrip(const Strip& strip) : strip_(strip) {}

    Body mesh(double size, const std::filesystem::path& folder) const override {
        const std::string recipe = fmt::format("layered strip 3 {} {} {} {} size {}", strip_.length, strip_.width, strip_.support,
                                               fmt::join(strip_.thicknesses, " "), size);
        Body body;
        body.mesh_file = cached_mesh(folder, "layered_strip", recipe, [&] { build(size); });
        for (std::size_t i = 0; i < names.size(); ++i) body.surfaces[names[i]] = static_cast<int>(i) + 1;
        body.regions = {{"odd", 1}, {"even", 2}};
        return body;
    }
    validation::Coordinates coordinates() const override {
        return {{"x", [](const auto& p) { return p[0]; }}, {"y", [](const auto& p) { return p[1]; }}, {"z", [](const auto& p) { return p[2]; }}};
    }
    double length(const std::string& key) const override {
        if (key == "height") return strip_.height();
        if (key == "length") return strip_.length;
        if (key == "width") return strip_.width;
        throw std::invalid_argument(fmt::format("one of height, length, width (not '{}')", key));
    }
    bool uniform_refinement() const override { return false; }
    std::vector<std::string> surface_names() const override { return names; }

private:
    /// Rectangles in the x-z plane, cut into grids of triangles, and swept along y in layers: flat tets follow thin layers.
    void build(double size) const {
        gmsh::vectorpair rectangles, pieces, swept;
        std::vector<gmsh::vectorpair> map;
        double z = 0;
        for (const double thickness : strip_.thicknesses) {
            rectangles.emplace_back(2, upright_rectangle(0, strip_.support, z, thickness));
            rectangles.emplace_back(2, upright_rectangle(strip_.support, strip_.length, z, thickness));
            z += thickness;
        }
        gmsh::model::occ::fragment(rectangles, {}, pieces, map);
        const int across = std::max(1, static_cast<int>(std::lround(strip_.width / (50 * size))));
        gmsh::model::occ::extrude(pieces, 0, strip_.width, 0, swept, {across}, {}, false);
        gmsh::model::occ::synchronize();
        divide_lines(size);
        for (const auto& [dim, tag] : pieces) gmsh::model::mesh::setTransfiniteSurface(tag);
        tag_entities();
    }

    /// OCC draws rectangles in the x-y plane.
    static int upright_rectangle(double x0, double x1, double z, double height) {
        const int tag = gmsh::model::occ::addRectangle(x0, 0, 0, x1 - x0, height);
        gmsh::model::occ::rotate({{2, tag}}, 0, 0, 0, 1, 0, 0, std::acos(0.0));
        gmsh::model::occ::translate({{2, tag}}, 0, 0, z);
        return tag;
    }

    /// Lines along x and z of the plane y = 0. Along x elements are twelve times as long as high, and shrink at both ends of
    /// each span (the supports and the load), by Gmsh's "Bump".
    void divide_lines(double size) const {
        gmsh::vectorpair curves;
        gmsh::model::getEntities(curves, 1);
        for (const auto& [dim, tag] : curves) {
            double x0, y0, z0, x1, y1, z1;
            gmsh::model::getBoundingBox(1, tag, x0, y0, z0, x1, y1, z1);
            const double dx = x1 - x0, dz = z1 - z0;
            if (y1 - y0 > 0.5 * strip_.width) continue;
            if (dx > dz)
                gmsh::model::mesh::setTransfiniteCurve(tag, 1 + std::max(2, static_cast<int>(std::lround(dx / (12 * size)))), "Bump", 0.1);
            else
                gmsh::model::mesh::setTransfiniteCurve(tag, 1 + std::max(1, static_cast<int>(std::lround(dz / size))));
        }
    }

    void tag_entities() const {
        gmsh::vectorpair volumes, faces;
        gmsh::model::getEntities(volumes, 3);
        std::map<int, std::vector<int>> regions, sides;
        for (const auto& [dim, tag] : volumes) regions[region_of(tag)].push_back(tag);
        for (const auto& [region, tags] : regions) gmsh::model::addPhysicalGroup(3, tags, region);
        gmsh::model::getEntities(faces, 2);
        for (const auto& [dim, tag] : faces)
            if (const int side = side_of(tag)) sides[side].push_back(tag);
        for (const auto& [side, tags] : sides) gmsh::model::addPhysicalGroup(2, tags, side);
    }

    int region_of(int volume) const {
        double x, y, z, top_of_layer = 0;
        gmsh::model::occ::getCenterOfMass(3, volume, x, y, z);
        for (std::size_t layer = 0; layer < strip_.thicknesses.size(); ++layer)
            if (z < (top_of_layer += strip_.thicknesses[layer])) return layer % 2 == 0 ? 1 : 2;
        throw std::logic_error("a layer above the strip");
    }

    /// 0 inside the body.
    int side_of(int face) const {
        double x, y, z;
        gmsh::model::occ::getCenterOfMass(2, face, x, y, z);
        const double near = 1e-6 * strip_.height();
        if (std::abs(x) < near) return left;
        if (std::abs(x - strip_.length) < near) return right;
        if (std::abs(y) < near) return front;
        if (std::abs(y - strip_.width) < near) return back;
        if (std::abs(z) < near) return x < strip_.support ? bottom_outer : bottom_inner;
        return std::abs(z - strip_.height()) < near ? top : 0;
    }

    Strip strip_;
};

}  // namespace

ShapeInfo layered_strip_info() {
    return {"layered_strip", "a strip of layers along z, regions odd and even, with a line across the bottom at x = support",
            {"length", "width", "thicknesses", "support"}, names, {"x", "y", "z"}};
}

std::shared_ptr<const Shape> read_layered_strip(TableReader& geometry) {
    Strip strip{geometry.quantity("length", dimension::length), geometry.quantity("width", dimension::length),
                geometry.quantity("support", dimension::length), {}};
    strip.thicknesses = read_quantities(geometry, "thicknesses", dimension::length);
    for (const double thickness : strip.thicknesses)
        if (!(thickness > 0)) geometry.fail("thicknesses", "positive lengths like '0.1 mm'");
    if (strip.thicknesses.size() < 2) geometry.fail("thicknesses", "at least two layers, from the bottom");
    if (!(strip.length > 0)) geometry.fail("length", "a positive length");
    if (!(strip.width > 0)) geometry.fail("width", "a positive length");
    if (!(strip.support > 0 && strip.support < strip.length)) geometry.fail("support", "a place between the ends");
    return std::make_shared<LayeredStrip>(strip);
}

}  // namespace cleave::geometry
