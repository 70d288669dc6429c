#pragma once

#include "reference_fem/mesh.hpp"

#include <optional>

namespace cleave::fem {

/// Finds the tet that holds a point, by a uniform grid over the bounding boxes of the tets. deal.II's own search returns wrong cells on
/// tets without a word (see test/deal_ii_traps_test.cpp), so it is not used.
class PointLocator {
public:
    /// Points up to `outside_tolerance` diameters of a tet outside it are still found. The mesh must outlive this object.
    PointLocator(const Mesh& mesh, double outside_tolerance);

    struct Place {
        int cell = 0;
        Point unit{};  ///< coordinates in the unit tet; barycentric coordinates of vertices 1 to 3
    };
    /// The tet that holds the point, to a slack of 1e-9; of several (the point lies on a face) the one of lowest index. For a point
    /// outside all tets the one it is nearest to, in diameters of that tet; empty if that is beyond the tolerance.
    std::optional<Place> find(const Point& point) const;

private:
    std::array<int, 3> bin_of(const Point& point) const;
    std::size_t bin_index(int i, int j, int k) const { return (static_cast<std::size_t>(k) * counts_[1] + j) * counts_[0] + i; }
    template <class Visit>
    void visit_bins(int cell, const Visit& visit) const;

    const Mesh& mesh_;
    double outside_tolerance_;
    Point low_{};
    Point high_{};
    std::array<int, 3> counts_{1, 1, 1};
    std::vector<int> bin_start_;  // compressed rows: cells whose box touches a bin
    std::vector<int> bin_cells_;
};

}  // namespace cleave::fem
