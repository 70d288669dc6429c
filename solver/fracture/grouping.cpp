#include "solver/fracture/grouping.hpp"

#include "solver/particles/nearest.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace cleave::fracture {

namespace {

using Order = std::vector<int>;  // places in `neighbours`, sorted
using Sets = std::vector<std::vector<int>>;

using particles::alike;

/// Values in whole steps of `alike` times the largest: those that differ by rounding only are equal, in an order that sorts.
std::vector<long long> in_steps(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    std::vector<long long> steps;
    for (const double value : values) steps.push_back(largest > 0 ? std::llround(value / (alike * largest)) : 0);
    return steps;
}

/// The order that all sums and all ties go by: it does not know the particles' numbers.
Order by_coordinates(const std::vector<Neighbour>& neighbours) {
    std::vector<double> coordinates;
    for (const Neighbour& neighbour : neighbours) coordinates.insert(coordinates.end(), neighbour.r.begin(), neighbour.r.end());
    const std::vector<long long> steps = in_steps(coordinates);
    const auto place = [&](int k) { return std::array{steps[3 * k], steps[3 * k + 1], steps[3 * k + 2]}; };
    Order order(neighbours.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return place(a) < place(b); });
    return order;
}

/// `order` by ascending key, cut into sets whose counts differ by one at most.
Sets cut_evenly(Order order, const std::vector<long long>& key, int groups) {
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key[a] < key[b]; });
    Sets sets(groups);
    const std::size_t count = order.size();
    for (std::size_t g = 0; g < sets.size(); ++g) {
        sets[g].assign(order.begin() + g * count / groups, order.begin() + (g + 1) * count / groups);
        std::sort(sets[g].begin(), sets[g].end());
    }
    return sets;
}

/// Any unit vector across `normal`.
Eigen::Vector3d across(const Eigen::Vector3d& normal) {
    Eigen::Index least = 0;
    normal.cwiseAbs().minCoeff(&least);
    return normal.cross(Eigen::Vector3d::Unit(least)).normalized();
}

/// Where the neighbours reach farthest across the normal: the larger axis of their second moments, on the side of the larger third moment.
Eigen::Vector3d widest_direction(const std::vector<Neighbour>& neighbours, const Order& order, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d e1 = across(normal), e2 = normal.cross(e1);
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    for (const int k : order) {
        const Eigen::Vector2d flat(neighbours[k].r.dot(e1), neighbours[k].r.dot(e2));
        second += neighbours[k].volume * flat * flat.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(second);
    if (solver.eigenvalues()(1) - solver.eigenvalues()(0) <= alike * solver.eigenvalues()(1)) return e1;  // alike all round
    const Eigen::Vector3d axis = solver.eigenvectors()(0, 1) * e1 + solver.eigenvectors()(1, 1) * e2;
    double third = 0, size = 0;
    for (const int k : order) {
        const double cube = neighbours[k].volume * std::pow(neighbours[k].r.dot(axis), 3);
        third += cube, size += std::abs(cube);
    }
    if (std::abs(third) <= alike * size) third = std::abs(axis.dot(e1)) > alike ? axis.dot(e1) : axis.dot(e2);  // as far to both sides
    return third < 0 ? Eigen::Vector3d(-axis) : axis;
}

Eigen::Vector3d azimuth_zero(const std::vector<Neighbour>& neighbours, const Order& order, const PointFrame& frame) {
    const Eigen::Vector3d tangent = frame.tangent - frame.tangent.dot(frame.normal) * frame.normal;
    return tangent.norm() > 1e-9 * frame.tangent.norm() ? Eigen::Vector3d(tangent.normalized()) : widest_direction(neighbours, order, frame.normal);
}

/// In steps of `alike` of a turn: an azimuth at the very start of the first sector must not turn up at the end of the last by rounding.
std::vector<long long> azimuths(const std::vector<Neighbour>& neighbours, const Order& order, const PointFrame& frame, int groups) {
    const double turn = 2 * std::numbers::pi;
    const long long steps = std::llround(1 / alike);
    const Eigen::Vector3d zero = azimuth_zero(neighbours, order, frame), side = frame.normal.cross(zero);
    std::vector<long long> key;
    for (const Neighbour& neighbour : neighbours) {
        const double from_start = std::atan2(neighbour.r.dot(side), neighbour.r.dot(zero)) + std::numbers::pi / groups;
        key.push_back((std::llround(from_start / turn * static_cast<double>(steps)) % steps + steps) % steps);
    }
    return key;
}

std::vector<long long> distances(const std::vector<Neighbour>& neighbours) {
    std::vector<double> key;
    for (const Neighbour& neighbour : neighbours) key.push_back(neighbour.r.norm());
    return in_steps(key);
}

Eigen::Vector3d mean_place(const std::vector<Neighbour>& neighbours, const Order& order) {
    double volume = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int k : order) {
        volume += neighbours[k].volume;
        sum += neighbours[k].volume * neighbours[k].r;
    }
    return sum / volume;
}

/// Gonzalez' seeds; fewer than `groups` where there are fewer places.
std::vector<Eigen::Vector3d> far_seeds(const std::vector<Neighbour>& neighbours, const Order& order, int groups) {
    std::vector<Eigen::Vector3d> seeds;
    std::vector<double> nearest(neighbours.size(), std::numeric_limits<double>::infinity());
    Eigen::Vector3d last = mean_place(neighbours, order);
    while (static_cast<int>(seeds.size()) < groups) {
        int farthest = order.front();
        for (const int k : order) {
            const double distance = (neighbours[k].r - last).squaredNorm();
            nearest[k] = seeds.empty() ? distance : std::min(nearest[k], distance);
            if (nearest[k] > (1 + alike) * nearest[farthest]) farthest = k;
        }
        if (!seeds.empty() && !(nearest[farthest] > 0)) break;
        if (seeds.empty()) std::fill(nearest.begin(), nearest.end(), std::numeric_limits<double>::infinity());
        last = neighbours[farthest].r;
        seeds.push_back(last);
    }
    return seeds;
}

/// Places by component: eight or more distances at a time.
struct Columns {
    std::array<std::vector<double>, 3> component;
    std::size_t size() const { return component[0].size(); }
};

Columns columns_of(const std::vector<Neighbour>& neighbours) {
    Columns columns;
    for (int i = 0; i < 3; ++i)
        for (const Neighbour& neighbour : neighbours) columns.component[i].push_back(neighbour.r[i]);
    return columns;
}

/// Number of the nearest centre of each place, of equally near ones the first, as a double (one width with the distances).
void assign_nearest(const Columns& places, const std::vector<Eigen::Vector3d>& centres, std::vector<double>& square, std::vector<double>& nearest) {
    std::fill(square.begin(), square.end(), std::numeric_limits<double>::infinity());
    std::fill(nearest.begin(), nearest.end(), 0.0);
    const double *x = places.component[0].data(), *y = places.component[1].data(), *z = places.component[2].data();
    double *best = square.data(), *number = nearest.data();
    for (std::size_t c = 0; c < centres.size(); ++c) {
        const double cx = centres[c][0], cy = centres[c][1], cz = centres[c][2], own = static_cast<double>(c);
        for (std::size_t k = 0; k < places.size(); ++k) {
            const double dx = x[k] - cx, dy = y[k] - cy, dz = z[k] - cz, distance = dx * dx + dy * dy + dz * dz;
            const bool nearer = distance < (1 - alike) * best[k];
            number[k] = nearer ? own : number[k];
            best[k] = nearer ? distance : best[k];
        }
    }
}

/// Each centre to the mean of its members; one without any stays.
void move_centres(const std::vector<Neighbour>& neighbours, const Order& order, const std::vector<double>& centre_of,
                  std::vector<Eigen::Vector3d>& centres) {
    std::vector<Eigen::Vector3d> sum(centres.size(), Eigen::Vector3d::Zero());
    std::vector<double> volume(centres.size(), 0);
    for (const int k : order) {
        const auto c = static_cast<std::size_t>(centre_of[k]);
        sum[c] += neighbours[k].volume * neighbours[k].r;
        volume[c] += neighbours[k].volume;
    }
    for (std::size_t c = 0; c < centres.size(); ++c)
        if (volume[c] > 0) centres[c] = sum[c] / volume[c];
}

Sets k_means(const std::vector<Neighbour>& neighbours, const Order& order, int groups) {
    constexpr int rounds = 100;  // assignments of some hundred places settle in about ten
    std::vector<Eigen::Vector3d> centres = far_seeds(neighbours, order, groups);
    const Columns places = columns_of(neighbours);
    std::vector<double> square(places.size()), centre_of(places.size(), -1), last;
    for (int round = 0; round < rounds; ++round) {
        last = centre_of;
        assign_nearest(places, centres, square, centre_of);
        if (centre_of == last) break;
        move_centres(neighbours, order, centre_of, centres);
    }
    Sets sets(groups);
    for (std::size_t k = 0; k < neighbours.size(); ++k) sets[static_cast<std::size_t>(centre_of[k])].push_back(static_cast<int>(k));
    return sets;
}

}  // namespace

std::vector<std::vector<int>> divide(const std::vector<Neighbour>& neighbours, const PointFrame& frame, Grouping rule, int groups) {
    if (groups < 1) throw std::invalid_argument("at least one group");
    if (neighbours.empty()) return Sets(groups);
    const Order order = by_coordinates(neighbours);
    switch (rule) {
        case Grouping::distance: return cut_evenly(order, distances(neighbours), groups);
        case Grouping::azimuth: return cut_evenly(order, azimuths(neighbours, order, frame, groups), groups);
        case Grouping::k_means: return k_means(neighbours, order, groups);
    }
    return {};
}

}  // namespace cleave::fracture
