#pragma once

#include <array>
#include <cstdint>

namespace cleave::subdivision {

/// Two half faces of a cut face by which all of its links are told: the first triangle of the quadrilateral's ring (the next three follow
/// at 4, 8, 12) and the lone vertex's triangle. Of a base: its second and its first piece.
struct alignas(8) LinkEnds {
    int ring, lone;
    static constexpr LinkEnds none() { return {-64, -64}; }  ///< still below 0 at all half faces of the ring
    /// Both moved by the same number.
    friend LinkEnds operator+(LinkEnds ends, LinkEnds by) { return {ends.ring + by.ring, ends.lone + by.lone}; }
};

/// Everything about a parent that is known before its children are written: points and links in the order of its layout, points by
/// number.
struct alignas(64) ParentPlan {
    std::array<int, 4> corner;      ///< vertices, by role
    std::array<int, 4> cut_point;
    std::array<int, 4> face_point;  ///< barycentres of cut faces; of a 3-1 parent the fourth is its base's
    int centre;                     ///< 2-2: the mean of the cut points
    int tet;
    int first_half_face;            ///< of its children
    std::uint16_t makes;            ///< bits of the points that this parent is the first to have: 0..3 cut points, 4..7 face points
    std::uint8_t layout;            ///< 2 * sign pattern + odd
    std::uint8_t inner_faces;       ///< bit k: a tet lies behind face k
    std::array<LinkEnds, 4> behind; ///< `none` at the boundary and where faces do not conform
    int behind_base;                ///< the original half face behind the fourth face, below 0: none
};
static_assert(sizeof(ParentPlan) == 128);

/// A face of a parent that did not conform when the parent was cut.
struct LooseFace {
    int face;                   ///< 4 * tet + sorted face
    int behind;                 ///< a base: the original half face behind it; -1: not a base
    std::array<int, 3> pieces;  ///< a base: its half faces
    double third;               ///< a base: the area of each, m^2
};

}  // namespace cleave::subdivision
