#include "validation/geometry/contact_block.hpp"

#include "validation/geometry/mesh_cache.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>

namespace cleave::geometry {

namespace {

enum Tag { contact = 1, top, outer, symmetry_x, symmetry_y };

int side_of(int face, const ContactBlock& block) {
    double x0, y0, z0, x1, y1, z1;
    gmsh::model::getBoundingBox(2, face, x0, y0, z0, x1, y1, z1);
    const double near = 0.01 * block.contact_radius;  // OCC widens boxes by its tolerance, 1e-7 m
    if (z0 > -near) return std::max(x1, y1) < 1.01 * block.contact_radius ? contact : top;
    if (block.sectors > 1 && x1 < near) return symmetry_x;
    if (block.sectors > 2 && y1 < near) return symmetry_y;
    return outer;
}

void tag_faces(const ContactBlock& block) {
    gmsh::vectorpair faces;
    gmsh::model::getEntities(faces, 2);
    std::map<int, std::vector<int>> groups;
    for (const auto& [dim, tag] : faces) groups[side_of(tag, block)].push_back(tag);
    for (const auto& [side, tags] : groups) gmsh::model::addPhysicalGroup(2, tags, side);
}

void set_sizes(const ContactBlock& block, double size) {
    const double a = block.contact_radius, rim_size = size / block.rim_refinement;
    gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
    gmsh::option::setNumber("Mesh.MeshSizeMin", 0);
    gmsh::option::setNumber("Mesh.MeshSizeMax", block.half_width);
    gmsh::model::mesh::setSizeCallback([=](int, int, double x, double y, double z) {
        const double r = std::hypot(x, y), away = std::hypot(std::max(0.0, r - a), z), from_rim = std::hypot(r - a, z);
        return std::min(size + 0.2 * std::min(away, a) + 0.4 * std::max(0.0, away - a), rim_size + 0.25 * from_rim);
    });
}

void build(const ContactBlock& block, double size) {
    const double w = block.half_width, x0 = block.sectors > 1 ? 0 : -w, y0 = block.sectors > 2 ? 0 : -w;
    const int box = gmsh::model::occ::addBox(x0, y0, -w, w - x0, w - y0, w);
    const int disk = gmsh::model::occ::addDisk(0, 0, 0, block.contact_radius, block.contact_radius);
    gmsh::vectorpair circle, pieces;
    std::vector<gmsh::vectorpair> map;
    gmsh::model::occ::intersect({{2, disk}}, {{2, gmsh::model::occ::addRectangle(x0, y0, 0, w - x0, w - y0)}}, circle, map);
    gmsh::model::occ::fragment({{3, box}}, circle, pieces, map);
    gmsh::model::occ::synchronize();
    gmsh::model::addPhysicalGroup(3, {map[0].front().second}, 1);
    tag_faces(block);
    set_sizes(block, size);
}

}  // namespace

Body mesh_contact_block(const ContactBlock& block, double size, const std::filesystem::path& folder) {
    const std::string recipe = fmt::format("contact block 3 {} {} {} {} size {}", block.contact_radius, block.half_width, block.sectors,
                                           block.rim_refinement, size);
    Body body;
    body.mesh_file = cached_mesh(folder, "contact_block", recipe, [&] { build(block, size); });
    body.surfaces = {{"contact", contact}, {"top", top}, {"outer", outer}};
    if (block.sectors > 1) body.surfaces["symmetry_x"] = symmetry_x;
    if (block.sectors > 2) body.surfaces["symmetry_y"] = symmetry_y;
    body.regions = {{"body", 1}};
    return body;
}

}  // namespace cleave::geometry
