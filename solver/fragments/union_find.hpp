#pragma once

#include <cstddef>
#include <vector>

namespace cleave::fragments {

/// Disjoint sets of numbers; the root of a set is its smallest member (Tarjan 1975, with path halving). Memory is kept between uses.
class UnionFind {
public:
    void grow(int size) {
        if (size > static_cast<int>(root_.size())) root_.resize(static_cast<std::size_t>(size));
    }
    void make_single(int number) { root_[number] = number; }
    int find(int number) {
        while (root_[number] != number) {
            root_[number] = root_[root_[number]];
            number = root_[number];
        }
        return number;
    }
    void unite(int a, int b) {
        a = find(a);
        b = find(b);
        if (a < b) root_[b] = a;
        else root_[a] = b;
    }

private:
    std::vector<int> root_;
};

}  // namespace cleave::fragments
