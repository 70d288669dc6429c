#pragma once

#include "solver/subdivision/canonical_mesh.hpp"
#include "solver/subdivision/cut.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cleave::fragments {

/// The original tets in blocks of 32 numbers, and what holds as long as no crack touches a block: which of its tets hang together
/// inside it (its parts), and which parts of other blocks they touch. A fragment's search then goes from part to part; only blocks
/// that a crack has touched are searched tet by tet.
class LinkBlocks {
public:
    static constexpr int size = 32;    ///< larger ones take less, but a crack touches more tets with each
    static constexpr int box_size = 8;  ///< tets to a bounding box: these cost hardly anything, and cracks are to look at few tets

    /// Whole blocks only: the last tets, if they fill none, belong to no block. `behind`: per tet, 4 * tet + face behind each face, or -1.
    LinkBlocks(std::span<const std::array<int, 4>> behind, const subdivision::CanonicalMesh& mesh);

    int blocks() const { return static_cast<int>(first_part_.size()) - 1; }
    /// The smallest tet of the part that a block's tet belongs to.
    int part_of(int tet) const { return (tet & ~(size - 1)) + offset_[static_cast<std::size_t>(tet)]; }
    /// The parts of a block, by their smallest tets.
    std::span<const int> parts(int block) const { return slice(parts_, first_part_, block); }
    /// Pairs of a part of this block and a linked part of a block before it, each once.
    std::span<const std::array<int, 2>> links_down(int block) const { return slice(links_, first_link_, block); }

    int boxes() const { return static_cast<int>(boxes_.size()); }
    /// 1 or -1 where all tets of a box (box_size numbers from box * box_size on) lie on that side of the plane (unit normal), so far from
    /// it that rounding cannot tell otherwise of any point between their vertices; else 0.
    int side(int box, const subdivision::Cut& plane) const;

private:
    struct Box {
        std::array<double, 3> centre, half;  ///< m
    };
    static Box box_around(int first, const subdivision::CanonicalMesh& mesh);
    template <class Value>
    static std::span<const Value> slice(const std::vector<Value>& values, const std::vector<std::size_t>& first, int block) {
        const auto at = static_cast<std::size_t>(block);
        return {values.data() + first[at], first[at + 1] - first[at]};
    }

    std::vector<std::uint8_t> offset_;           ///< per tet of a block: part_of, counted from the block's first tet
    std::vector<int> parts_;
    std::vector<std::array<int, 2>> links_;
    std::vector<Box> boxes_;                     ///< per box_size tets
    std::vector<std::size_t> first_part_, first_link_;  ///< per block, and one more
};

}  // namespace cleave::fragments
