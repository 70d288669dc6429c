#include "solver/fragments/link_blocks.hpp"

#include "solver/fragments/union_find.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleave::fragments {

LinkBlocks::LinkBlocks(std::span<const std::array<int, 4>> behind, const subdivision::CanonicalMesh& mesh)
    : offset_(behind.size() / size * size), first_part_{0}, first_link_{0} {
    UnionFind inside;
    inside.grow(size);
    for (int first = 0; first < static_cast<int>(offset_.size()); first += size) {
        for (int i = 0; i < size; ++i) {
            inside.make_single(i);
            for (const int half_face : behind[static_cast<std::size_t>(first + i)]) {
                const int other = (half_face >> 2) - first;
                if (half_face >= 0 && other >= 0 && other < i) inside.unite(i, other);
            }
        }
        for (int i = 0; i < size; ++i) {
            offset_[static_cast<std::size_t>(first + i)] = static_cast<std::uint8_t>(inside.find(i));
            if (inside.find(i) == i) parts_.push_back(first + i);
        }
        const std::size_t before = links_.size();
        for (int tet = first; tet < first + size; ++tet) {
            for (const int half_face : behind[static_cast<std::size_t>(tet)]) {
                if (half_face >= 0 && half_face >> 2 < first) links_.push_back({part_of(tet), part_of(half_face >> 2)});
            }
        }
        const auto own = links_.begin() + static_cast<std::ptrdiff_t>(before);
        std::sort(own, links_.end());
        links_.erase(std::unique(own, links_.end()), links_.end());
        Box& box = boxes_.emplace_back();
        box.low.fill(std::numeric_limits<double>::infinity());
        box.high.fill(-std::numeric_limits<double>::infinity());
        for (int tet = first; tet < first + size; ++tet) {
            for (const int vertex : mesh.records[static_cast<std::size_t>(tet)].sorted) {
                const subdivision::Vector4& x = mesh.vertices[static_cast<std::size_t>(vertex)];
                for (int axis = 0; axis < 3; ++axis) {
                    box.low[axis] = std::min(box.low[axis], x[axis]);
                    box.high[axis] = std::max(box.high[axis], x[axis]);
                }
            }
        }
        first_part_.push_back(parts_.size());
        first_link_.push_back(links_.size());
    }
}

bool LinkBlocks::is_beside(int block, const subdivision::Cut& plane) const {
    const Box& box = boxes_[static_cast<std::size_t>(block)];
    double distance = 0, reach = 0, size = 0;
    for (int axis = 0; axis < 3; ++axis) {
        distance += plane.normal[axis] * (0.5 * (box.low[axis] + box.high[axis]) - plane.centre[axis]);
        reach += std::abs(plane.normal[axis]) * 0.5 * (box.high[axis] - box.low[axis]);
        size += std::abs(box.low[axis]) + std::abs(box.high[axis]) + std::abs(plane.centre[axis]);
    }
    return std::abs(distance) > reach + 1e-14 * size;  // far above the rounding of these few sums
}

}  // namespace cleave::fragments
