#include "solver/elasticity/conforming_box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace cleave::elasticity {

namespace {
constexpr int leaf_size = 8;
}

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), ids_(boxes_.size()) {
    std::iota(ids_.begin(), ids_.end(), 0);
    if (!boxes_.empty()) build(0, static_cast<int>(boxes_.size()));
}

int BoxTree::build(int first, int last) {
    Box box;
    for (int n = first; n < last; ++n) box.extend(boxes_[ids_[n]]);
    const int node = static_cast<int>(nodes_.size());
    nodes_.push_back({box, first, last});
    if (last - first <= leaf_size) return node;
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const int middle = (first + last) / 2;
    const auto before = [&](int a, int b) {
        const double x = boxes_[a].center()[axis], y = boxes_[b].center()[axis];
        return x < y || (x == y && a < b);
    };
    std::nth_element(ids_.begin() + first, ids_.begin() + middle, ids_.begin() + last, before);
    const int left = build(first, middle), right = build(middle, last);
    nodes_[node].left = left;
    nodes_[node].right = right;
    return node;
}

std::vector<int> BoxTree::touching(const Box& query) const {
    std::vector<int> found, open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
        const Node& node = nodes_[open.back()];
        open.pop_back();
        if (!node.box.intersects(query)) continue;
        if (node.left >= 0) {
            open.push_back(node.left);
            open.push_back(node.right);
            continue;
        }
        for (int n = node.first; n < node.last; ++n)
            if (boxes_[ids_[n]].intersects(query)) found.push_back(ids_[n]);
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace cleave::elasticity
