#pragma once

#include "solver/subdivision/canonical_mesh.hpp"
#include "solver/subdivision/cut.hpp"
#include "solver/subdivision/cutting_plane.hpp"

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace cleave::subdivision {

/// Finds the tets that a plane divides without looking at the others: tets along a Morton curve, up to 64 with up to 64 vertices to a
/// box, 64 boxes to a larger one, and so on to one. A box keeps its vertices side by side and knows each tet's as a set of bits, so
/// that a tet costs two or three instructions. Deterministic.
class TetBoxes {
public:
    TetBoxes() = default;
    explicit TetBoxes(const CanonicalMesh& mesh);

    /// Calls visit(box) for the boxes of tets that the cut (with a unit normal) may pass; visit_box then goes through the box's tets.
    template <class Visit>
    void near_boxes(const Cut& cut, const Visit& visit) const {
        if (!levels_.empty()) descend(cut, levels_.size() - 1, 0, levels_.back().size(), visit);
    }

    static constexpr std::size_t most = 64;  ///< tets of a box, and vertices

    /// Asks the memory for what visit_box will read of a box: along the curve, boxes near a plane stand anywhere.
    void prefetch(std::size_t box) const {
        const Span &first = spans_[box], &last = spans_[box + 1];
        prefetch(&corners_[first.corner], &corners_[last.corner - 1] + 1);
        prefetch(&members_[first.tet], &members_[last.tet - 1] + 1);
        prefetch(&items_[first.tet], &items_[last.tet - 1] + 1);
    }

    /// Calls visit(tet, number) for each tet of the box with vertices on both sides of the plane (d >= 0 is '+'). The number is that of
    /// piece_tables(): 2 * plus_mask + odd, bit i of the mask belonging to sorted vertex i.
    template <class Visit>
    void visit_box(std::size_t box, const CuttingPlane& plane, const Visit& visit) const {
        const Span& first = spans_[box];
        const Span& last = spans_[box + 1];
        std::uint64_t plus = 0;
        for (std::size_t i = first.corner; i < last.corner; ++i) {
            const FourCorners& four = corners_[i];
            plus |= std::uint64_t{plus_mask(plane.distance(four.x, four.y, four.z))} << 4 * (i - first.corner);
        }
        const __m256i all_plus = _mm256_set1_epi64x(static_cast<long long>(plus)), none = _mm256_setzero_si256();
        for (std::size_t i = first.tet; i < last.tet; i += 4) {
            const __m256i own = _mm256_load_si256(reinterpret_cast<const __m256i*>(&members_[i]));
            const __m256i on_plus = _mm256_and_si256(own, all_plus);
            const __m256i same = _mm256_or_si256(_mm256_cmpeq_epi64(on_plus, none), _mm256_cmpeq_epi64(on_plus, own));
            unsigned divided = ~static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd(same))) & 15U;
            for (; divided != 0; divided &= divided - 1) {
                const Item& item = items_[i + static_cast<std::size_t>(std::countr_zero(divided))];
                unsigned mask = 0;
                for (int k = 0; k < 4; ++k) mask |= static_cast<unsigned>(plus >> item.corner[k] & 1U) << k;
                visit(static_cast<int>(item.twice_tet >> 1), 2 * mask + (item.twice_tet & 1U));
            }
        }
    }

private:
    struct Box {
        std::array<double, 3> centre, half;  ///< m
        bool touches(const Cut& cut) const;
    };
    struct Item {
        unsigned twice_tet;                  ///< 2 * tet + odd
        std::array<std::uint8_t, 4> corner;  ///< its sorted vertices, as numbers in the box
    };
    struct FourCorners {
        Vector4 x, y, z;  ///< m
    };
    /// Where a box starts.
    struct Span {
        std::size_t corner;  ///< in corners_
        std::size_t tet;     ///< in items_ and members_, a multiple of four
    };
    class Filler;

    static void prefetch(const void* first, const void* last) {
        constexpr std::uintptr_t line = 64;
        const auto* at = static_cast<const char*>(first) - reinterpret_cast<std::uintptr_t>(first) % line;
        for (; at < static_cast<const char*>(last); at += line) __builtin_prefetch(at);
    }

    template <class Visit>
    void descend(const Cut& cut, std::size_t level, std::size_t first, std::size_t last, const Visit& visit) const {
        for (std::size_t box = first; box < last; ++box) {
            if (!levels_[level][box].touches(cut)) continue;
            if (level > 0) {
                descend(cut, level - 1, 64 * box, std::min(64 * box + 64, levels_[level - 1].size()), visit);
            } else {
                visit(box);
            }
        }
    }

    LargeVector<Item> items_;               ///< tets along the curve; each box is filled up to a multiple of four
    LargeVector<std::uint64_t> members_;    ///< per item: bit i: vertex i of the box is the tet's; 0: no tet
    LargeVector<FourCorners> corners_;      ///< the boxes' vertices; the last one is repeated to a multiple of four
    std::vector<Span> spans_;               ///< per box, and one past the last
    std::vector<std::vector<Box>> levels_;  ///< [0] the boxes of tets, the last one of at most 64 boxes
};

}  // namespace cleave::subdivision
