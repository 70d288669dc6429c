#pragma once

#include <array>
#include <cstdint>

namespace cleave::subdivision {

/// Everything about a parent that is known before its children are written: points in the order of its roles (ParentLayout), by
/// number.
struct alignas(16) ParentPlan {
    std::array<int, 4> corner;      ///< vertices
    std::array<int, 4> cut_point;   ///< of a 3-1 parent the first three
    std::array<int, 4> face_point;  ///< barycentres of cut faces; of a 3-1 parent the fourth is its base's
    int centre;                     ///< 2-2: the mean of the cut points
    int tet;
    int first_child;                ///< among the children
    std::uint16_t makes;            ///< bit i: this parent is the first to have point i (of CutTemplate::points)
    std::uint8_t layout;            ///< 2 * sign pattern + odd
    std::array<int, 4> behind;      ///< 4 * tet + sorted face behind each face, -1: none
};
static_assert(sizeof(ParentPlan) == 80);

}  // namespace cleave::subdivision
