#include "solver/subdivision/test/engine_equals.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

namespace cleave::subdivision::test {
namespace {

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

bool same_areas(const std::vector<ExtraLink>& a, const std::vector<ExtraLink>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::bit_cast<std::uint64_t>(a[i].area) != std::bit_cast<std::uint64_t>(b[i].area)) return false;
    }
    return true;
}

}  // namespace

std::string first_difference(const Subdivided& a, const Subdivided& b) {
    if (a.counts != b.counts) return "counts";
    if (!same_bits(a.mesh.vertices, b.mesh.vertices)) return "vertices";
    if (a.mesh.tets != b.mesh.tets) return "tets";
    if (a.mesh.regions != b.mesh.regions) return "regions";
    if (a.mesh.surface != b.mesh.surface) return "surface";
    if (a.parent != b.parent) return "parent";
    if (a.cut != b.cut) return "cut";
    if (a.side != b.side) return "side";
    if (!same_bits(a.volume, b.volume)) return "volume";
    if (!same_bits(a.centroid, b.centroid)) return "centroid";
    if (a.parent_face != b.parent_face) return "parent_face";
    if (a.links.opposite != b.links.opposite) return "links";
    if (a.extra_links != b.extra_links || !same_areas(a.extra_links, b.extra_links)) return "extra_links";
    return "";
}

}  // namespace cleave::subdivision::test
