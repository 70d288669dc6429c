#pragma once

#include "solver/subdivision/canonical_mesh.hpp"
#include "solver/subdivision/cut.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace cleave::subdivision {

/// Finds the tets near a plane or disc without looking at the others: tets along a Morton curve, 64 to a box, 64 boxes to a
/// larger one, and so on to one. Deterministic.
class TetBoxes {
public:
    TetBoxes() = default;
    explicit TetBoxes(const CanonicalMesh& mesh);

    /// Calls visit(tet, its sorted vertices) for at least each tet that the cut (with a unit normal) may pass, in no order of use.
    template <class Visit>
    void near(const Cut& cut, const Visit& visit) const {
        near_boxes(cut, [&](std::size_t box) { visit_box(box, visit); });
    }

    /// Calls visit(box) for the boxes of 64 tets that the cut may pass; visit_box(box, visit) then goes through the box's tets.
    template <class Visit>
    void near_boxes(const Cut& cut, const Visit& visit) const {
        if (!levels_.empty()) descend(cut, levels_.size() - 1, 0, levels_.back().size(), visit);
    }
    template <class Visit>
    void visit_box(std::size_t box, const Visit& visit) const {
        for (std::size_t i = 64 * box; i < std::min(64 * box + 64, items_.size()); ++i) visit(items_[i].tet, items_[i].sorted);
    }

private:
    struct Box {
        std::array<double, 3> centre, half;  ///< m
        bool touches(const Cut& cut) const;
    };

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

    struct Item {
        int tet;
        std::array<int, 4> sorted;
    };
    LargeVector<Item> items_;               ///< tets along the curve
    std::vector<std::vector<Box>> levels_;  ///< [0] of 64 tets each, the last one of at most 64 boxes
};

}  // namespace cleave::subdivision
