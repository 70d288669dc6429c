#pragma once

#include <Eigen/Geometry>

#include <vector>

namespace cleave::elasticity {

using Box = Eigen::AlignedBox3d;

/// Boxes (points too) in a balanced tree, for queries by box in bodies of any grading. Deterministic.
class BoxTree {
public:
    explicit BoxTree(std::vector<Box> boxes);

    /// Ids of all boxes that touch `query`, ascending.
    std::vector<int> touching(const Box& query) const;

private:
    struct Node {
        Box box;
        int first, last;  ///< range of ids_
        int left = -1, right = -1;
    };

    int build(int first, int last);

    std::vector<Box> boxes_;
    std::vector<int> ids_;
    std::vector<Node> nodes_;
};

}  // namespace cleave::elasticity
