#include "solver/fragments/child_groups.hpp"

#include <algorithm>

namespace cleave::fragments {
namespace {

using subdivision::PieceTable;

ChildGroup group_of(const PieceTable& pieces, int first) {
    ChildGroup group{.first = first};
    const int side = pieces.side[first];
    while (first + group.count < pieces.children && pieces.side[first + group.count] == side) ++group.count;
    std::array<bool, 4> known{};
    for (int i = 0; i < group.count; ++i) {
        for (int face = 0; face < 4; ++face) {
            const int child = first + i, behind = pieces.inner[child][face], on = pieces.face[child][face];
            if (behind >= 0 && pieces.side[behind / 4] == side) group.inner[i] |= static_cast<std::uint8_t>(1U << face);
            if (on < 0 || known[on]) continue;
            known[on] = true;
            group.face[group.faces++] = static_cast<std::uint8_t>(4 * child + face);
        }
    }
    return group;
}

/// By table, then '+' or '-' side first: both sides of a template stand in a row.
std::array<std::array<ChildGroup, 2>, 32> all_groups() {
    std::array<std::array<ChildGroup, 2>, 32> groups;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const PieceTable& pieces = subdivision::piece_tables()[i];
        if (pieces.children == 0) continue;
        groups[i][0] = group_of(pieces, 0);
        groups[i][1] = group_of(pieces, groups[i][0].count);
    }
    return groups;
}

}  // namespace

const ChildGroup& group_from(const PieceTable& pieces, int child) {
    static const auto groups = all_groups();
    static const ChildGroup none;
    const auto& [one, other] = groups[static_cast<std::size_t>(&pieces - subdivision::piece_tables().data())];
    return child == one.first ? one : child == other.first ? other : none;
}

}  // namespace cleave::fragments
