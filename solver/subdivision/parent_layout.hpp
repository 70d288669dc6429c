#pragma once

#include "solver/subdivision/parent_plan.hpp"
#include "solver/subdivision/piece_tables.hpp"

#include <array>
#include <cstdint>

namespace cleave::subdivision {

/// What the writer of children takes from a table: two children at a time, eight numbers in a register.
struct alignas(32) ChildPattern {
    static constexpr int most_pairs = PieceTable::most_children / 2;
    using Eight = std::array<std::int32_t, 8>;
    /// The corners: places in the first eight numbers of a plan and in those from its faces on (ParentPlan), and where the latter count.
    alignas(32) std::array<Eight, most_pairs> from_corners{}, from_faces{}, takes_face{};
    /// Half faces inside the parent (from its first child's on); half faces behind (from the first that lies behind a quadrilateral's
    /// ring), and where the latter count.
    alignas(32) std::array<Eight, most_pairs> inner{}, outer{}, is_outer{};
    std::array<std::uint8_t, 4> lone{};  ///< 4 * child + face of the triangle beside each quadrilateral, by face of the plan
    std::array<std::uint8_t, 3> base{};  ///< 4 * child + face of each piece of a base
    int barycentre = -1;                 ///< 3-1: the corner of child 1 that is the base's barycentre
};

/// How a parent of one sign pattern and orientation is seen in the roles of its vertices (CutTemplate): there, all 3-1 parents are
/// alike and all 2-2 ones. Faces stand in the order of the quadrilaterals of the children; a 3-1 parent's base is the last.
struct ParentLayout {
    enum Kind : std::uint8_t { not_cut, lone_plus, lone_minus, two_two };

    /// Cut edge and face number k. A 3-1 parent's fourth edge is its first once more.
    struct Own {
        std::uint8_t edge;  ///< its number 0..5
        std::uint8_t face;  ///< the sorted vertex opposite
    };
    /// A base's third piece stands so many half faces after its first.
    static constexpr int third_piece = 32;

    const ChildPattern* pattern = nullptr;
    Kind kind = not_cut;
    std::uint8_t children = 0;
    std::int8_t base_face = -1;              ///< sorted vertex opposite, -1: none
    std::array<Own, 4> own{};
    std::array<std::uint8_t, 4> place{};     ///< of a face in `own`, by the sorted vertex opposite
    std::array<LinkEnds, 4> ends{};          ///< the links to a face end here (from the first child's half faces on), by the sorted vertex opposite
    // For registers of four ints: byte shuffles, and lanes of eight ints.
    alignas(16) std::array<std::uint8_t, 16> role_bytes{};  ///< the sorted vertices by role
    alignas(16) std::array<std::uint8_t, 16> face_bytes{};  ///< what stands by sorted face, in the order of `own`
    alignas(16) std::array<std::uint8_t, 16> cut_bytes{};   ///< cut points; a 3-1 parent's fourth is its first once more
    alignas(32) std::array<std::int32_t, 8> edge_lanes{};   ///< what stands by edge, in the order of `own` (in the lower half)
    unsigned cut_edges = 0;                                  ///< bit k: the cut edge k is not one once more
};

/// `place` and `ends` of all layouts side by side, by 4 * number of the layout + sorted face.
struct FaceTables {
    alignas(64) std::array<std::int32_t, 128> place{};
    alignas(64) std::array<LinkEnds, 128> ends{};
};

/// By 2 * m + odd, as piece_tables().
const std::array<ParentLayout, 32>& parent_layouts();
const FaceTables& face_tables();

}  // namespace cleave::subdivision
