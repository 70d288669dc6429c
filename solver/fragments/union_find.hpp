#pragma once

#include "solver/subdivision/huge_pages.hpp"

#include <algorithm>
#include <cstddef>

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
    /// Joins the sets of a root and of another number; returns the root of both.
    int unite_root(int root, int number) {
        if (root_[number] == root) return root;  // by far the most
        const int other = find(number);
        if (other < root) return root_[root] = other;
        root_[other] = root;
        return root;
    }
    void unite(int a, int b) { unite_root(find(a), b); }

    /// Lets a number point to its root: look_up then needs no search. For all numbers of a set, ascending.
    void flatten(int number) { root_[number] = root_[root_[number]]; }  // the smaller ones are flat already
    /// Puts numbers in a row into the set of another, which is flat.
    void follow(int first, int count, int other) {
        const int root = root_[other];
        std::fill_n(root_.begin() + first, count, root);
    }
    int look_up(int number) const { return root_[number]; }

private:
    subdivision::LargeVector<int> root_;
};

}  // namespace cleave::fragments
