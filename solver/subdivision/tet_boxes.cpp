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
        const Vector4* x = mesh.vertices.data();
        const Vector4 sum = (x[tet.sorted[0]] + x[tet.sorted[1]]) + (x[tet.sorted[2]] + x[tet.sorted[3]]);
        centres.emplace_back(sum[0], sum[1], sum[2]);
    }
    return mesh::coarse_morton_order(centres);
}

}  // namespace

/// Puts tets into boxes, one after another.
class TetBoxes::Filler {
public:
    Filler(TetBoxes& boxes, const CanonicalMesh& mesh) : boxes_(boxes), mesh_(mesh), known_(mesh.vertices.size(), {-1, 0}) {
        boxes_.spans_.push_back({0, 0});
        boxes_.levels_.emplace_back();
    }

    void add(int tet) {
        const CanonicalMesh::Record& record = mesh_.records[tet];
        const auto& sorted = record.sorted;
        const auto fresh = std::count_if(sorted.begin(), sorted.end(), [&](int v) { return known_[v].box != box(); });
        if (tets_ == most || vertices_.size() + static_cast<std::size_t>(fresh) > most) close();
        Item item{2 * static_cast<unsigned>(tet) + record.odd, {}};
        std::uint64_t members = 0;
        for (int k = 0; k < 4; ++k) {
            item.corner[k] = number_of(sorted[k]);
            members |= std::uint64_t{1} << item.corner[k];
        }
        boxes_.items_.push_back(item);
        boxes_.members_.push_back(members);
        ++tets_;
    }

    void close() {
        if (tets_ == 0) return;
        Bounds bounds;
        for (const int v : vertices_) {
            for (int axis = 0; axis < 3; ++axis) bounds.add(axis, mesh_.vertices[v][axis], mesh_.vertices[v][axis]);
        }
        while (vertices_.size() % 4 != 0) vertices_.push_back(vertices_.back());
        for (std::size_t i = 0; i < vertices_.size(); i += 4) {
            const Vector4* x = mesh_.vertices.data();
            const FourVertices four(x[vertices_[i]], x[vertices_[i + 1]], x[vertices_[i + 2]], x[vertices_[i + 3]]);
            boxes_.corners_.push_back({four.x, four.y, four.z});
        }
        while (boxes_.items_.size() % 4 != 0) {
            boxes_.items_.push_back({});
            boxes_.members_.push_back(0);
        }
        boxes_.spans_.push_back({boxes_.corners_.size(), boxes_.items_.size()});
        boxes_.levels_[0].push_back(box_of(bounds));
        vertices_.clear();
        tets_ = 0;
    }

    static Box box_of(const Bounds& bounds) {
        Box box{};
        for (int axis = 0; axis < 3; ++axis) {
            box.centre[axis] = 0.5 * (bounds.low[axis] + bounds.high[axis]);
            box.half[axis] = 0.5 * (bounds.high[axis] - bounds.low[axis]);
        }
        return box;
    }

private:
    int box() const { return static_cast<int>(boxes_.levels_[0].size()); }

    std::uint8_t number_of(int vertex) {
        auto& [in_box, number] = known_[vertex];
        if (in_box != box()) {
            in_box = box();
            number = static_cast<int>(vertices_.size());
            vertices_.push_back(vertex);
        }
        return static_cast<std::uint8_t>(number);
    }

    struct Known {
        int box, number;
    };
    TetBoxes& boxes_;
    const CanonicalMesh& mesh_;
    std::vector<Known> known_;    ///< per vertex: the last box that had it, and its number there
    std::vector<int> vertices_;   ///< of the open box
    std::size_t tets_ = 0;        ///< in the open box
};

TetBoxes::TetBoxes(const CanonicalMesh& mesh) {
    items_.reserve(mesh.records.size() + mesh.records.size() / 8);
    members_.reserve(mesh.records.size() + mesh.records.size() / 8);
    Filler filler(*this, mesh);
    for (const int tet : along_curve(mesh)) filler.add(tet);
    filler.close();
    while (levels_.back().size() > 64) {
        const std::vector<Box>& below = levels_.back();
        std::vector<Box> boxes((below.size() + 63) / 64);
        for (std::size_t box = 0; box < boxes.size(); ++box) {
            Bounds bounds;
            for (std::size_t i = 64 * box; i < std::min(64 * box + 64, below.size()); ++i) {
                for (int axis = 0; axis < 3; ++axis) {
                    bounds.add(axis, below[i].centre[axis] - below[i].half[axis], below[i].centre[axis] + below[i].half[axis]);
                }
            }
            boxes[box] = Filler::box_of(bounds);
        }
        levels_.push_back(std::move(boxes));
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
