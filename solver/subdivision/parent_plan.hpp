#pragma once

#include <array>
#include <cstdint>

namespace cleave::subdivision {

/// Everything about a parent that is known before its children are written: points and links in the order of its layout, points by
/// number.
struct alignas(64) ParentPlan {
    static constexpr int unlinked = -64;  ///< in `ring`: still below 0 at all of its half faces

    std::array<int, 4> corner;      ///< vertices, by role
    std::array<int, 4> cut_point;
    std::array<int, 4> face_point;  ///< barycentres of cut faces; of a 3-1 parent the fourth is its base's
    int centre;                     ///< 2-2: the mean of the cut points
    int tet;
    int first_half_face;            ///< of its children
    std::uint16_t makes;            ///< this parent is the first to have: bits 0..3 the cut points, 4..7 the face points, 8 the centre
    std::uint8_t layout;            ///< 2 * sign pattern + odd
    std::uint8_t inner_faces;       ///< bit k: a tet lies behind face k
    /// Half faces behind the first triangle of each quadrilateral's ring (the next three follow at 4, 8, 12), `unlinked` at the boundary
    /// and where faces do not conform; behind the lone vertex's triangle, or -1. Of a base: behind its second and its first piece.
    std::array<int, 4> ring, lone;
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
