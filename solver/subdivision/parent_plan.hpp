#pragma once

#include <array>
#include <cstdint>

namespace cleave::subdivision {

/// What lies behind a parent's faces: half faces, or -1 at the boundary and where faces do not conform.
struct OuterLinks {
    static constexpr int none = -64;  ///< for `ring`: still below 0 at all of its half faces
    std::array<int, 4> ring;  ///< behind the first triangle of the quadrilateral's ring; the next three follow at 4, 8, 12
    std::array<int, 4> lone;  ///< behind the lone vertex's triangle
    std::array<int, 3> base;  ///< behind the pieces of a base
};

/// Everything about a parent that is known before its children are written: points and links in the order of its roles
/// (ParentLayout), points by number.
struct alignas(64) ParentPlan {
    std::array<int, 4> corner;      ///< vertices
    std::array<int, 4> cut_point;   ///< of a 3-1 parent the first three
    std::array<int, 4> face_point;  ///< barycentres of cut faces; of a 3-1 parent the fourth is its base's
    int centre;                     ///< 2-2: the mean of the cut points
    int tet;
    int first_child;                ///< among the children
    std::uint16_t makes;            ///< bit i: this parent is the first to have point i (of CutTemplate::points)
    std::uint8_t layout;            ///< 2 * sign pattern + odd
    std::uint8_t inner_faces;       ///< bit k: a tet lies behind face k (of the layout)
    OuterLinks outer;
    int behind_base;                ///< the original half face behind the base, -1: none
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
