#pragma once

#include "solver/particles/particles.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace cleave::particles {

/// For each particle i the others j != i inside its support |G_i (x_j - x_i)| < 1, by ascending id, in one compressed array.
/// Not symmetric: i may see j without j seeing i.
struct NeighbourLists {
    std::vector<std::size_t> offset;  ///< size() + 1 entries
    std::vector<int> index;

    int size() const { return static_cast<int>(offset.size()) - 1; }
    std::span<const int> of(int i) const { return {index.data() + offset[i], offset[i + 1] - offset[i]}; }
};

/// Points sorted into cubic cells, for exact queries by box. Deterministic.
class CellGrid {
public:
    /// `cell` (m) > 0 is the edge wished for; it grows until there are at most a few cells per point.
    CellGrid(const std::vector<Eigen::Vector3d>& points, double cell);

    /// Appends the ids of all points of the cells that touch the box: a superset of those inside it, each once.
    void collect(const Eigen::Vector3d& low, const Eigen::Vector3d& high, std::vector<int>& ids) const;

private:
    int cell_of(double coordinate, int axis) const;
    std::size_t cell_index(int x, int y, int z) const;

    Eigen::Vector3d origin_;
    double cell_ = 1;
    std::array<int, 3> count_{};
    std::vector<std::size_t> first_;  // of each cell in ids_, one more at the end
    std::vector<int> ids_;
};

/// Edge of the cells that suits these particles: half the mean support radius.
double suitable_cell(const Particles& particles);

/// All lists (NeighbourSearch). O(n log n) for bodies whose supports hold a bounded number of particles.
NeighbourLists find_neighbours(const Particles& particles);

/// The same; memory of `lists` is used again.
void find_neighbours(const Particles& particles, NeighbourLists& lists);

/// Ids of the particles inside |G (x_j - x)| < 1 around any point, ascending; one that sits at the point included.
std::vector<int> neighbours_of_point(const Particles& particles, const CellGrid& grid, const Eigen::Vector3d& point,
                                     const Eigen::Matrix3d& tensor);

/// The definition, O(n^2): the oracle of find_neighbours.
NeighbourLists find_neighbours_brute_force(const Particles& particles);

}  // namespace cleave::particles
