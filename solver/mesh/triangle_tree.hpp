#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <functional>
#include <vector>

namespace cleave::mesh {

/// Squared distance from a point to a triangle, m^2.
double squared_distance(const Eigen::Vector3d& point, const std::array<Eigen::Vector3d, 3>& triangle);

/// Triangles in a binary tree of boxes, for nearest ones.
class TriangleTree {
public:
    explicit TriangleTree(std::vector<std::array<Eigen::Vector3d, 3>> triangles);

    /// The nearest triangle that `allowed` lets pass, the smallest number where several are equally near; -1 where none passes.
    int nearest(const Eigen::Vector3d& point, const std::function<bool(int)>& allowed) const;

private:
    struct Node {
        Eigen::AlignedBox3d box;
        int first = 0, last = 0;      ///< in order_
        int left = -1, right = -1;    ///< -1 in a leaf
    };
    struct Found {
        double distance;  ///< squared
        int triangle;
    };

    int build(int first, int last);
    void search(int node, const Eigen::Vector3d& point, const std::function<bool(int)>& allowed, Found& best) const;

    std::vector<std::array<Eigen::Vector3d, 3>> triangles_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

}  // namespace cleave::mesh
