#include "solver/mesh/triangle_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace cleave::mesh {
namespace {

constexpr int leaf_size = 8;

double squared_distance_to_segment(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3d along = b - a;
    const double t = along.squaredNorm() > 0 ? std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
    return (point - a - t * along).squaredNorm();
}

}  // namespace

double squared_distance(const Eigen::Vector3d& point, const std::array<Eigen::Vector3d, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const auto inside = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) { return normal.dot((to - from).cross(point - from)) >= 0; };
    if (normal.squaredNorm() > 0 && inside(a, b) && inside(b, c) && inside(c, a)) {
        const double height = normal.dot(point - a);
        return height * height / normal.squaredNorm();
    }
    return std::min({squared_distance_to_segment(point, a, b), squared_distance_to_segment(point, b, c), squared_distance_to_segment(point, c, a)});
}

TriangleTree::TriangleTree(std::vector<std::array<Eigen::Vector3d, 3>> triangles) : triangles_(std::move(triangles)), order_(triangles_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!triangles_.empty()) build(0, static_cast<int>(order_.size()));
}

int TriangleTree::build(int first, int last) {
    const int number = static_cast<int>(nodes_.size());
    Node node;
    node.first = first;
    node.last = last;
    for (int i = first; i < last; ++i) {
        for (const Eigen::Vector3d& corner : triangles_[order_[i]]) node.box.extend(corner);
    }
    nodes_.push_back(node);
    if (last - first <= leaf_size) return number;
    int axis = 0;
    node.box.sizes().maxCoeff(&axis);
    const int middle = (first + last) / 2;
    const auto key = [&](int i) { return triangles_[i][0][axis] + triangles_[i][1][axis] + triangles_[i][2][axis]; };
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](int i, int j) { return std::pair(key(i), i) < std::pair(key(j), j); });
    const int left = build(first, middle), right = build(middle, last);
    nodes_[number].left = left;
    nodes_[number].right = right;
    return number;
}

void TriangleTree::search(int number, const Eigen::Vector3d& point, const std::function<bool(int)>& allowed, Found& best) const {
    const Node& node = nodes_[number];
    if (node.box.squaredExteriorDistance(point) > best.distance) return;
    if (node.left >= 0) {
        const bool left_first = nodes_[node.left].box.squaredExteriorDistance(point) <= nodes_[node.right].box.squaredExteriorDistance(point);
        search(left_first ? node.left : node.right, point, allowed, best);
        search(left_first ? node.right : node.left, point, allowed, best);
        return;
    }
    for (int i = node.first; i < node.last; ++i) {
        const int triangle = order_[i];
        const double distance = squared_distance(point, triangles_[triangle]);
        const bool nearer = distance < best.distance || (distance == best.distance && triangle < best.triangle);
        if (nearer && allowed(triangle)) best = {distance, triangle};
    }
}

int TriangleTree::nearest(const Eigen::Vector3d& point, const std::function<bool(int)>& allowed) const {
    Found best{std::numeric_limits<double>::infinity(), -1};
    if (!nodes_.empty()) search(0, point, allowed, best);
    return best.triangle;
}

}  // namespace cleave::mesh
