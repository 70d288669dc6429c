#include "solver/subdivision/parent_layout.hpp"

#include <algorithm>
#include <bit>

namespace cleave::subdivision {
namespace {

/// The first child of each quadrilateral's ring, in the order of the template's children.
std::array<int, 4> first_of_rings(bool two_two) { return two_two ? std::array<int, 4>{2, 6, 12, 16} : std::array<int, 4>{2, 6, 10, -1}; }

/// Codes of a template in the places of a plan: four corners, four cut points, then four barycentres of faces (of a 3-1 parent the
/// fourth is its base's) and the centre.
std::array<int, 15> places_of(const CutTemplate& cut) {
    std::array<int, 15> places{};
    for (int i = 0; i < 4; ++i) places[cut.roles[i]] = i;
    const int cuts = cut.centre ? 4 : 3;
    for (int i = 0; i < cuts; ++i) places[cut.points[i]] = 4 + i;
    for (int i = 0; i < cuts; ++i) places[cut.points[cuts + i]] = 8 + i;
    places[cut.points[2 * cuts]] = cut.centre ? 12 : 11;
    return places;
}

std::uint8_t half_face_on(const PieceTable& pieces, int child, int parent_face) {
    const auto& faces = pieces.face[child];
    return static_cast<std::uint8_t>(4 * child + (std::find(faces.begin(), faces.end(), parent_face) - faces.begin()));
}

/// The child beside a quadrilateral that has the lone vertex's triangle of the face.
int lone_child(const PieceTable& pieces, const std::array<int, 4>& rings, int cuts, int parent_face) {
    for (int child = 0; child < pieces.children; ++child) {
        const bool in_ring = std::any_of(rings.begin(), rings.begin() + cuts, [child](int first) { return child >= first && child < first + 4; });
        const auto& faces = pieces.face[child];
        if (!in_ring && std::find(faces.begin(), faces.end(), parent_face) != faces.end()) return child;
    }
    return -1;
}

ParentLayout layout_of(unsigned plus_mask, const PieceTable& pieces) {
    ParentLayout layout;
    const CutTemplate& cut = cut_template(plus_mask);
    if (cut.children.empty()) return layout;
    const std::array<int, 4> rings = first_of_rings(cut.centre);
    const int cuts = cut.centre ? 4 : 3;
    layout.kind = cut.centre ? ParentLayout::two_two : std::popcount(plus_mask) == 1 ? ParentLayout::lone_plus : ParentLayout::lone_minus;
    layout.children = static_cast<std::uint8_t>(pieces.children);
    layout.base_face = static_cast<std::int8_t>(cut.base_face);
    for (int k = 0; k < 4; ++k) {
        ParentLayout::Own& own = layout.own[k];
        own.edge = static_cast<std::uint8_t>(cut.points[k < cuts ? k : 0] - first_edge_code);
        own.face = static_cast<std::uint8_t>(k < cuts ? cut.points[cuts + k] - first_face_code : cut.base_face);
        layout.place[own.face] = static_cast<std::uint8_t>(k);
        layout.ends[own.face] = {half_face_on(pieces, k < cuts ? rings[k] : rings[1] + 2, own.face),
                                 half_face_on(pieces, k < cuts ? lone_child(pieces, rings, cuts, own.face) : rings[0] + 2, own.face)};
        for (int byte = 0; byte < 4; ++byte) {
            layout.role_bytes[4 * k + byte] = static_cast<std::uint8_t>(4 * cut.roles[k] + byte);
            layout.face_bytes[4 * k + byte] = static_cast<std::uint8_t>(4 * own.face + byte);
            layout.cut_bytes[4 * k + byte] = static_cast<std::uint8_t>(4 * (k < cuts ? k : 0) + byte);
        }
        layout.edge_lanes[k] = own.edge;
    }
    layout.cut_edges = (1U << cuts) - 1;
    return layout;
}

ChildPattern pattern_of(const CutTemplate& cut, const PieceTable& pieces, const ParentLayout& layout) {
    ChildPattern pattern;
    const std::array<int, 15> places = places_of(cut);
    const std::array<int, 4> rings = first_of_rings(cut.centre);
    const int cuts = cut.centre ? 4 : 3;
    for (int slot = 0; slot < 4 * pieces.children; ++slot) {
        const int child = slot / 4, pair = slot / 8, lane = slot % 8, place = places[pieces.codes[child][slot % 4]];
        (place < 8 ? pattern.from_corners : pattern.from_faces)[pair][lane] = place % 8;
        pattern.takes_face[pair][lane] = place < 8 ? 0 : -1;
        pattern.inner[pair][lane] = pieces.inner[child][slot % 4];
        for (int k = 0; k < cuts; ++k) {
            const bool outer = child >= rings[k] && child < rings[k] + 4 && pieces.face[child][slot % 4] == layout.own[k].face;
            if (!outer) continue;
            pattern.outer[pair][lane] = 4 * (child - rings[k]);
            pattern.is_outer[pair][lane] = -1;
        }
    }
    for (int k = 0; k < cuts; ++k) pattern.lone[k] = static_cast<std::uint8_t>(layout.ends[layout.own[k].face].lone);
    if (cut.base_face >= 0) {
        for (int k = 0; k < 3; ++k) pattern.base[k] = half_face_on(pieces, rings[k] + 2, cut.base_face);
        const auto& below = pieces.codes[1];
        pattern.barycentre = static_cast<int>(std::find(below.begin(), below.end(), first_face_code + cut.base_face) - below.begin());
    }
    return pattern;
}

/// 3-1 and 2-2 in a pattern whose roles are the sorted order, both orientations.
const std::array<ChildPattern, 4>& patterns() {
    static const std::array<ChildPattern, 4> all = [] {
        std::array<ChildPattern, 4> made;
        for (unsigned i = 0; i < 4; ++i) {
            const unsigned plus_mask = i < 2 ? 0b0001U : 0b0011U;
            const PieceTable& pieces = piece_tables()[2 * plus_mask + i % 2];
            made[i] = pattern_of(cut_template(plus_mask), pieces, layout_of(plus_mask, pieces));
        }
        return made;
    }();
    return all;
}

bool is_odd(const std::array<int, 4>& permutation) {
    bool odd = false;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < i; ++j) odd ^= permutation[j] > permutation[i];
    }
    return odd;
}

}  // namespace

const std::array<ParentLayout, 32>& parent_layouts() {
    static const std::array<ParentLayout, 32> all = [] {
        std::array<ParentLayout, 32> made;
        for (unsigned i = 0; i < 32; ++i) {
            made[i] = layout_of(i / 2, piece_tables()[i]);
            const bool turned = is_odd(cut_template(i / 2).roles) != (i % 2 == 1);
            made[i].pattern = &patterns()[(made[i].kind == ParentLayout::two_two ? 2U : 0U) + (turned ? 1U : 0U)];
        }
        return made;
    }();
    return all;
}

const FaceTables& face_tables() {
    static const FaceTables all = [] {
        FaceTables made;
        for (std::size_t i = 0; i < 128; ++i) {
            const ParentLayout& layout = parent_layouts()[i / 4];
            made.place[i] = layout.place[i % 4];
            made.ends[i] = layout.ends[i % 4];
        }
        return made;
    }();
    return all;
}

}  // namespace cleave::subdivision
