#pragma once

#include "solver/particles/neighbours.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace cleave::particles {

/// All neighbour lists at once. The particles are halved again and again at the middle of their box, and with each half go the points that
/// its supports may reach, always by ascending id. In the end a dozen particles are left with a few hundred points, of which each reads
/// eight at a time (Highway): its list comes out by ascending id, and nothing is sorted. Coordinates are in single precision; what is too
/// near to the edge of a support to tell is settled by the definition, in double precision.
///
/// The halves follow the particles wherever they are, so graded bodies and long kernels need no size of a cell. CellGrid (neighbours.hpp)
/// answers single queries.
class NeighbourSearch {
public:
    /// `particles` must outlive the search.
    explicit NeighbourSearch(const Particles& particles);

    /// The lists of find_neighbours_brute_force, to the last bit; memory of `lists` is used again.
    void find(NeighbourLists& lists);

private:
    /// Rows of single precision in structure-of-arrays form, longer than `count` by whole vectors.
    template <std::size_t columns>
    struct Table {
        std::array<std::vector<float>, columns> column;
        std::vector<int> id;
        std::size_t count = 0;

        void make_room(std::size_t rows);
        void close();
    };
    using Points = Table<3>;   ///< x, y, z from the origin
    using Queries = Table<6>;  ///< the same, and half the edges of the box around the support, rounded up
    struct Box;
    struct Support;
    /// What the halves at one depth consist of.
    struct Level {
        Queries low, high;
        Points near;
    };

    template <std::size_t columns, class Wanted>
    static void filter(const Table<columns>& from, Table<columns>& to, const Wanted& wanted);
    void divide(const Queries& queries, const Points& near, std::size_t depth);
    void search(const Queries& queries, const Points& near);
    template <bool round, bool settles>
    std::size_t collect(const Support& support, const Points& near, int* to) const;
    template <bool round>
    std::size_t collect_surely(const Support& support, const Points& near, int* to) const;
    std::size_t settle(const Support& support, const Points& near, std::size_t n, std::size_t in, std::size_t maybe) const;
    void make_room_for(std::size_t more);
    void copy_by_id(NeighbourLists& lists) const;

    const Particles& particles_;
    Eigen::Vector3d origin_;
    Queries all_;
    Points everywhere_;
    std::vector<std::unique_ptr<Level>> levels_;
    // Lists in the order in which they are found, every particle in its own: where each begins, and how long it is.
    std::unique_ptr<int[]> found_;
    std::size_t end_ = 0, room_ = 0;
    std::vector<std::size_t> first_, length_;
};

/// |G r| < 1: the definition of a support.
bool is_inside(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& r);

}  // namespace cleave::particles
