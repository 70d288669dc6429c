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
            for (const int half_face : behind[first + i]) {
                const int other = (half_face >> 2) - first;
                if (half_face >= 0 && other >= 0 && other < i) inside.unite(i, other);
            }
        }
        for (int i = 0; i < size; ++i) {
            offset_[first + i] = static_cast<std::uint8_t>(inside.find(i));
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
        first_part_.push_back(parts_.size());
        first_link_.push_back(links_.size());
    }
    for (int first = 0; first < static_cast<int>(offset_.size()); first += box_size) boxes_.push_back(box_around(first, mesh));
}

LinkBlocks::Box LinkBlocks::box_around(int first, const subdivision::CanonicalMesh& mesh) {
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (int tet = first; tet < first + box_size; ++tet) {
        for (const int vertex : mesh.records[static_cast<std::size_t>(tet)].sorted) {
            const subdivision::Vector4& x = mesh.vertices[static_cast<std::size_t>(vertex)];
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], x[axis]);
                high[axis] = std::max(high[axis], x[axis]);
            }
        }
    }
    Box box{};
    for (int axis = 0; axis < 3; ++axis) {
        box.centre[axis] = 0.5 * (low[axis] + high[axis]);
        box.half[axis] = 0.5 * (high[axis] - low[axis]);
    }
    return box;
}

int LinkBlocks::side(int box, const subdivision::Cut& plane) const {
    const auto& [centre, half] = boxes_[static_cast<std::size_t>(box)];
    double distance = 0, reach = 0, size = 0;
    for (int axis = 0; axis < 3; ++axis) {
        distance += plane.normal[axis] * (centre[axis] - plane.centre[axis]);
        reach += std::abs(plane.normal[axis]) * half[axis];
        size += std::abs(centre[axis]) + half[axis] + std::abs(plane.centre[axis]);
    }
    const double slack = 1e-14 * size;  // far above the rounding of these few sums
    return (distance > reach + slack) - (distance < -reach - slack);
}

}  // namespace cleave::fragments
