#pragma once

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
    const ChildPattern* pattern = nullptr;
    std::array<std::uint8_t, 4> role{};      ///< sorted vertex by role
    std::array<std::uint8_t, 4> edge{};      ///< by cut edge in the order of CutTemplate::points: its number 0..5
    std::array<std::uint8_t, 4> face{};      ///< the sorted vertex opposite each face
    std::array<std::uint8_t, 4> place{};     ///< by the sorted vertex opposite: the place of the face in `face`
    std::array<std::uint8_t, 4> ring{}, lone{};  ///< by the sorted vertex opposite a cut face: half faces of the ring's first triangle, of the lone one
    std::array<std::uint8_t, 3> base{};      ///< half faces of the base's pieces
    std::int8_t base_face = -1;              ///< sorted vertex opposite, -1: none
    std::uint8_t cuts = 0;                   ///< cut edges, and cut faces too: 3 or 4; 0: not cut
    std::uint8_t children = 0;
    bool lone_plus = false;                  ///< 3-1: the lone vertex is '+'
    alignas(16) std::array<std::uint8_t, 16> role_bytes{};  ///< `role` as a byte shuffle of four ints
};

/// By 2 * m + odd, as piece_tables().
const std::array<ParentLayout, 32>& parent_layouts();

}  // namespace cleave::subdivision
