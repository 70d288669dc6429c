#include "solver/subdivision/tet_boxes.hpp"

#include "solver/mesh/morton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleave::subdivision {
namespace {

struct Bounds {
    std::array<double, 3> low, high;
    Bounds() {
        low.fill(std::numeric_limits<double>::infinity());
        high.fill(-std::numeric_limits<double>::infinity());
    }
    void add(int axis, double from, double to) {
        low[axis] = std::min(low[axis], from);
        high[axis] = std::max(high[axis], to);
    }
};

std::vector<int> along_curve(const CanonicalMesh& mesh) {
    std::vector<Eigen::Vector3d> centres;
    centres.reserve(mesh.tets());
    for (const CanonicalMesh::Record& tet : mesh.records) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const int v : tet.sorted) sum += Eigen::Vector3d(mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]);
        centres.push_back(sum / 4);
    }
    return mesh::morton_order(centres);
}

}  // namespace

TetBoxes::TetBoxes(const CanonicalMesh& mesh) {
    items_.reserve(mesh.records.size());
    for (const int tet : along_curve(mesh)) items_.push_back({tet, mesh.records[tet].sorted});
    const auto make_level = [&](std::size_t items, const auto& add_item) {
        std::vector<Box> boxes((items + 63) / 64);
        for (std::size_t box = 0; box < boxes.size(); ++box) {
            Bounds bounds;
            for (std::size_t i = 64 * box; i < std::min(64 * box + 64, items); ++i) add_item(bounds, i);
            for (int axis = 0; axis < 3; ++axis) {
                boxes[box].centre[axis] = 0.5 * (bounds.low[axis] + bounds.high[axis]);
                boxes[box].half[axis] = 0.5 * (bounds.high[axis] - bounds.low[axis]);
            }
        }
        levels_.push_back(std::move(boxes));
    };
    make_level(items_.size(), [&](Bounds& bounds, std::size_t i) {
        for (const int v : items_[i].sorted) {
            for (int axis = 0; axis < 3; ++axis) bounds.add(axis, mesh.vertices[v][axis], mesh.vertices[v][axis]);
        }
    });
    while (levels_.back().size() > 64) {
        const std::vector<Box> below = levels_.back();
        make_level(below.size(), [&](Bounds& bounds, std::size_t i) {
            for (int axis = 0; axis < 3; ++axis) {
                bounds.add(axis, below[i].centre[axis] - below[i].half[axis], below[i].centre[axis] + below[i].half[axis]);
            }
        });
    }
}

bool TetBoxes::Box::touches(const Cut& cut) const {
    double distance = 0, reach = 0, size = 0, apart = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double offset = centre[axis] - cut.centre[axis];
        distance += cut.normal[axis] * offset;
        reach += std::abs(cut.normal[axis]) * half[axis];
        size += std::abs(centre[axis]) + std::abs(cut.centre[axis]) + half[axis];
        const double gap = std::max(std::abs(offset) - half[axis], 0.0);
        apart += gap * gap;
    }
    const double slack = 1e-14 * size;  // far above the rounding of these few sums, far below a tet
    return std::abs(distance) <= reach + slack && std::sqrt(apart) <= cut.radius + slack;
}

}  // namespace cleave::subdivision
