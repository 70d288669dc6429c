#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cleave::particles {

/// Points sorted into cells as large as a support, coordinates stored cell after cell in single precision: a query reads a few long rows,
/// eight points at a time (Highway), and settles what is too near to the edge of the support by the definition, in double precision. For
/// queries by the thousand; CellGrid (neighbours.hpp) is the simple form.
class NeighbourSearch {
public:
    /// `cell` (m) > 0 is the edge wished for, the usual support radius; it grows until there are at most a few cells per point.
    /// `points` must outlive the search.
    NeighbourSearch(const std::vector<Eigen::Vector3d>& points, double cell);

    /// The ids of all points with |G (x - point)| < 1, by ascending id, but for `self` (-1: none is left out), appended to `ids`.
    /// `tensor` (1/m) is symmetric. The same set as is_inside gives for each point, to the last bit.
    void append(const Eigen::Vector3d& point, const Eigen::Matrix3d& tensor, int self, std::vector<int>& ids);

private:
    struct Query;

    int cell_of(double coordinate, int axis) const;
    std::size_t cell_index(int x, int y, int z) const;
    double gap(double coordinate, int cell, int axis) const;
    void find_rows(const Query& query);
    template <bool round>
    std::size_t collect(const Query& query);
    unsigned settle(const Query& query, std::size_t n, unsigned in, unsigned maybe) const;
    void append_sorted(std::size_t count, int self, std::vector<int>& ids);

    const std::vector<Eigen::Vector3d>& points_;
    Eigen::Vector3d origin_, edge_, per_edge_;
    std::array<int, 3> count_{};
    std::vector<std::size_t> first_;       // of each cell in the arrays below, one more at the end
    std::vector<int> ids_;                 // by cell, x fastest, ascending within one; padded to whole vectors
    std::array<std::vector<float>, 3> x_;  // likewise, from the origin
    // Of one query: what it reads, what it finds, and the order of that.
    std::vector<std::pair<std::size_t, std::size_t>> ranges_;
    std::vector<int> found_, rank_;
    std::vector<std::int16_t> short_keys_, short_rank_;
};

/// |G r| < 1: the definition of a support.
bool is_inside(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& r);

}  // namespace cleave::particles
