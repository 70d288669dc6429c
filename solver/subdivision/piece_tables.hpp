#pragma once

#include "solver/subdivision/templates.hpp"

#include <array>
#include <cstdint>

namespace cleave::subdivision {

/// The pieces of one face of a cut parent, in an order that both tets at the face agree on (a piece is told by the ranks of the
/// face's three sorted vertices): piece k of one side faces piece k of the other where both have the same pieces.
struct FacePieces {
    int count = 0;                              ///< 3 (base) or 5 (cut)
    std::array<std::uint8_t, 5> half_face{};    ///< 4 * child + face, by piece
    std::array<std::uint8_t, 5> ascending{};    ///< the same, sorted
};

/// A template laid out for speed: what each child takes, and who its inner neighbours are.
struct PieceTable {
    static constexpr int most_children = 20;
    static constexpr std::int32_t outer = -1;
    int children = 0;
    std::array<std::array<std::uint8_t, 4>, most_children> codes{};   ///< PointCode of each corner
    std::array<std::array<std::int32_t, 4>, most_children> inner{};   ///< 4 * child + face behind each face, or `outer`
    std::array<std::int8_t, most_children> side{};                    ///< +1 or -1
    std::array<std::array<std::int8_t, 4>, most_children> face{};     ///< sorted parent's face that a face lies on, -1 inside
    std::array<FacePieces, 4> pieces{};                               ///< by the sorted parent's face
    int base_face = -1;                                               ///< 3-1: the uncut face
};

/// By 2 * m + odd, m the sign pattern (bit i: sorted vertex i is '+'), odd: whether the sorted parent has the other orientation.
/// The children stand in cut_template's order; an odd parent's have corners 2 and 3 exchanged.
const std::array<PieceTable, 32>& piece_tables();

}  // namespace cleave::subdivision
