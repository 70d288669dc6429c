#include "validation/geometry/shape.hpp"

#include "validation/geometry/block.hpp"
#include "validation/geometry/elliptic_plate.hpp"
#include "validation/geometry/imported.hpp"
#include "validation/geometry/laminate_block.hpp"
#include "validation/geometry/layered_strip.hpp"
#include "validation/geometry/penny_octant.hpp"
#include "validation/geometry/plate_with_hole.hpp"
#include "validation/geometry/round_cracks.hpp"
#include "validation/geometry/straight_cracks.hpp"

#include <fmt/format.h>

namespace cleave::geometry {

namespace {

using ReadShape = std::shared_ptr<const Shape> (*)(TableReader&);

struct Entry {
    ShapeInfo info;
    ReadShape read;
};

const std::vector<Entry>& entries() {
    static const std::vector<Entry> list{{block_info(), read_block}, {laminate_block_info(), read_laminate_block},
                                         {plate_with_hole_info(), read_plate_with_hole},
                                         {penny_crack_block_info(), read_penny_crack_block},
                                         {elliptic_plate_info(), read_elliptic_plate},
                                         {layered_strip_info(), read_layered_strip},
                                         {penny_octant_info(), read_penny_octant},
                                         {elliptical_crack_block_info(), read_elliptical_crack_block},
                                         {cap_crack_block_info(), read_cap_crack_block},
                                         {corner_crack_block_info(), read_corner_crack_block},
                                         {through_crack_block_info(), read_through_crack_block},
                                         {edge_crack_block_info(), read_edge_crack_block}};
    return list;
}

}  // namespace

const std::vector<ShapeInfo>& shapes() {
    static const std::vector<ShapeInfo> list = [] {
        std::vector<ShapeInfo> infos;
        for (const Entry& entry : entries()) infos.push_back(entry.info);
        infos.push_back(imported_info());
        return infos;
    }();
    return list;
}

std::shared_ptr<const Shape> read_shape(TableReader& geometry) {
    if (geometry.has("mesh") && geometry.has("shape")) geometry.fail("", "either 'shape' or 'mesh'");
    if (geometry.has("mesh")) return read_imported(geometry);
    std::vector<std::string> names;
    for (const Entry& entry : entries()) names.push_back(entry.info.name);
    const std::string name = geometry.choice("shape", names);
    for (const Entry& entry : entries())
        if (entry.info.name == name) return entry.read(geometry);
    return nullptr;
}

}  // namespace cleave::geometry
