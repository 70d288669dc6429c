#include "solver/particles/neighbours.hpp"

#include "solver/particles/neighbour_search.hpp"
#include "solver/particles/smoothing_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cleave::particles {

namespace {

/// More cells than this per point cost memory and gain nothing.
constexpr double cells_per_point = 4;

void append_list(NeighbourLists& lists, const std::vector<int>& ids, int self) {
    for (const int j : ids)
        if (j != self) lists.index.push_back(j);
    lists.offset.push_back(lists.index.size());
}

}  // namespace

CellGrid::CellGrid(const std::vector<Eigen::Vector3d>& points, double cell) : origin_(Eigen::Vector3d::Zero()), cell_(cell) {
    Eigen::Vector3d extent = Eigen::Vector3d::Zero();
    if (!points.empty()) {
        Eigen::Vector3d high = origin_ = points[0];
        for (const Eigen::Vector3d& point : points) {
            origin_ = origin_.cwiseMin(point);
            high = high.cwiseMax(point);
        }
        extent = high - origin_;
    }
    const double limit = cells_per_point * static_cast<double>(points.size()) + 64;
    const auto cells = [&] { return ((extent / cell_).array().floor() + 1).prod(); };
    while (cells() > limit) cell_ *= 1.25;
    for (int axis = 0; axis < 3; ++axis) count_[axis] = static_cast<int>(std::floor(extent[axis] / cell_)) + 1;

    std::vector<std::size_t> cell_of_point(points.size());
    first_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        cell_of_point[i] = cell_index(cell_of(points[i][0], 0), cell_of(points[i][1], 1), cell_of(points[i][2], 2));
        ++first_[cell_of_point[i] + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    ids_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) ids_[next[cell_of_point[i]]++] = static_cast<int>(i);
}

int CellGrid::cell_of(double coordinate, int axis) const {
    // Clamped before the conversion: a query box may lie far outside.
    const double cell = std::floor((coordinate - origin_[axis]) / cell_);
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(count_[axis] - 1)));
}

std::size_t CellGrid::cell_index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * count_[1] + y) * count_[0] + x;
}

void CellGrid::collect(const Eigen::Vector3d& low, const Eigen::Vector3d& high, std::vector<int>& ids) const {
    const int x0 = cell_of(low[0], 0), x1 = cell_of(high[0], 0);
    for (int z = cell_of(low[2], 2); z <= cell_of(high[2], 2); ++z)
        for (int y = cell_of(low[1], 1); y <= cell_of(high[1], 1); ++y) {
            // Cells along x lie one after the other.
            const auto begin = ids_.begin() + static_cast<std::ptrdiff_t>(first_[cell_index(x0, y, z)]);
            const auto end = ids_.begin() + static_cast<std::ptrdiff_t>(first_[cell_index(x1, y, z) + 1]);
            ids.insert(ids.end(), begin, end);
        }
}

double suitable_cell(const Particles& particles) {
    if (particles.size() == 0) return 1;
    const double sum = std::accumulate(particles.support_radius.begin(), particles.support_radius.end(), 0.0);
    return 0.5 * sum / particles.size();
}

std::vector<int> neighbours_of_point(const Particles& particles, const CellGrid& grid, const Eigen::Vector3d& point,
                                     const Eigen::Matrix3d& tensor) {
    const Eigen::Vector3d box = support_box(tensor);
    std::vector<int> ids;
    grid.collect(point - box, point + box, ids);
    std::erase_if(ids, [&](int j) { return !is_inside(tensor, particles.position[j] - point); });
    std::sort(ids.begin(), ids.end());
    return ids;
}

void find_neighbours(const Particles& particles, NeighbourLists& lists) { NeighbourSearch(particles).find(lists); }

NeighbourLists find_neighbours(const Particles& particles) {
    NeighbourLists lists;
    find_neighbours(particles, lists);
    return lists;
}

NeighbourLists find_neighbours_brute_force(const Particles& particles) {
    NeighbourLists lists;
    lists.offset.push_back(0);
    for (int i = 0; i < particles.size(); ++i) {
        std::vector<int> ids;
        for (int j = 0; j < particles.size(); ++j)
            if (is_inside(particles.tensor[i], particles.position[j] - particles.position[i])) ids.push_back(j);
        append_list(lists, ids, i);
    }
    return lists;
}

}  // namespace cleave::particles
