#pragma once

#include "solver/subdivision/piece_tables.hpp"

#include <array>
#include <cstdint>

namespace cleave::fragments {

/// The children of one parent on one side of its cut. They stand in a row and hang together as long as they lose no link among
/// themselves; then one link through each of the parent's faces tells where that face leads.
struct ChildGroup {
    static constexpr int most_children = subdivision::PieceTable::most_children;
    int first = 0, count = 0;                        ///< children, counted from the parent's first
    int faces = 0;
    std::array<std::uint8_t, 4> face{};              ///< one half face on each of the parent's faces, counted from the parent's first child
    std::array<std::uint8_t, most_children> inner{};  ///< by child of the group: bits of its faces to others of the group
};

/// The group that starts with a child of a parent divided like this; count 0 where none does.
const ChildGroup& group_from(const subdivision::PieceTable& pieces, int child);

}  // namespace cleave::fragments
