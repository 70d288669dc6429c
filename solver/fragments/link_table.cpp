#include "solver/fragments/link_table.hpp"

#include <algorithm>

namespace cleave::fragments {
namespace {

using subdivision::SubdivisionEngine;

std::uint64_t pair_key(int first, int second) {
    const auto [low, high] = std::minmax(first, second);
    return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

/// Per original tet, in its own order of faces.
subdivision::LargeVector<std::array<int, 4>> original_links(const SubdivisionEngine& engine) {
    const auto& records = engine.canonical().records;
    subdivision::LargeVector<std::array<int, 4>> links(records.size());
    for (std::size_t tet = 0; tet < links.size(); ++tet) {
        const auto& record = records[tet];
        for (int face = 0; face < 4; ++face) {
            const int behind = record.opposite[face];
            links[tet][record.position[face]] = behind < 0 ? -1 : (behind & ~3) | record.position_behind(face);
        }
    }
    return links;
}

}  // namespace

LinkTable::LinkTable(const SubdivisionEngine& engine)
    : own_(original_links(engine)), blocks_(own_, engine.canonical()), state_(static_cast<std::size_t>(engine.originals()), 0) {}

void LinkTable::reset() {
    state_.assign(own_.size(), 0);
    partial_.clear();
}

void LinkTable::take_over(const SubdivisionEngine& engine) {
    removed_pairs_.clear();
    for (const PartialLink& partial : partial_) {
        if (partial.removed) removed_pairs_.push_back(pair_key(partial.link.first, partial.link.second));
    }
    std::sort(removed_pairs_.begin(), removed_pairs_.end());
    state_.resize(own_.size() + engine.child_tets().size(), 0);
    for (const int parent : engine.last_parents()) {
        state_[parent] |= gone;
        pass_on_removals(engine, parent);
    }
    engine.find_extra_links(scratch_);
    partial_.clear();
    for (const subdivision::ExtraLink& link : scratch_) {
        partial_.push_back({link, was_removed(engine, before_cut(engine, link.first), before_cut(engine, link.second))});
    }
}

/// The half face before the current cut that a half face is a part of.
int LinkTable::before_cut(const SubdivisionEngine& engine, int half_face) const {
    const int child = half_face / 4 - originals();
    if (child < 0 || child < engine.first_new_child()) return half_face;
    return engine.original_half_face(half_face);
}

/// Whether the link between two half faces had been removed before the current cut.
bool LinkTable::was_removed(const SubdivisionEngine& engine, int first, int second) const {
    const bool both_original = first / 4 < originals() && second / 4 < originals();
    if (both_original && opposite(engine, first) == second) return is_removed(first);
    return std::binary_search(removed_pairs_.begin(), removed_pairs_.end(), pair_key(first, second));
}

/// Equal faces between the pieces of a parent and what lies behind them.
void LinkTable::pass_on_removals(const SubdivisionEngine& engine, int parent) {
    if (removed_pairs_.empty() && (state_[parent] & 15U) == 0) return;
    const subdivision::PieceTable& pieces = engine.pieces(parent);
    for (int k = 0; k < pieces.children; ++k) {
        for (int face = 0; face < 4; ++face) {
            if (pieces.face[k][face] < 0) continue;
            const int here = 4 * (originals() + engine.first_child(parent) + k) + face, there = opposite(engine, here);
            if (there >= 0 && was_removed(engine, before_cut(engine, here), before_cut(engine, there))) remove(engine, here);
        }
    }
}

void LinkTable::remove(const SubdivisionEngine& engine, int half_face) {
    const int behind = opposite(engine, half_face);
    state_[half_face / 4] |= static_cast<std::uint8_t>(1U << half_face % 4);
    if (behind >= 0) state_[behind / 4] |= static_cast<std::uint8_t>(1U << behind % 4);
}

}  // namespace cleave::fragments
