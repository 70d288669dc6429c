#include "solver/fracture/grouping.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace cleave::fracture {
namespace {

const PointFrame frame{Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero()};
constexpr std::array rules{Grouping::distance, Grouping::azimuth, Grouping::k_means};

std::vector<Neighbour> half_ball(int count, unsigned seed = 7) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<Neighbour> neighbours;
    while (static_cast<int>(neighbours.size()) < count) {
        const Eigen::Vector3d r(uniform(generator), uniform(generator), std::abs(uniform(generator)));
        if (r.norm() < 1) neighbours.push_back({r, 1 + 0.3 * uniform(generator)});
    }
    return neighbours;
}

/// Sets by their members' places instead of their numbers.
std::vector<std::set<std::array<double, 3>>> by_place(const std::vector<Neighbour>& neighbours, const std::vector<std::vector<int>>& sets) {
    std::vector<std::set<std::array<double, 3>>> result;
    for (const auto& set : sets) {
        auto& places = result.emplace_back();
        for (const int k : set) places.insert({neighbours[k].r.x(), neighbours[k].r.y(), neighbours[k].r.z()});
    }
    return result;
}

TEST(Divide, EveryNeighbourOnceInAscendingOrder) {
    const auto neighbours = half_ball(103);
    for (const Grouping rule : rules)
        for (const int groups : {1, 2, 5}) {
            std::vector<int> all;
            const auto sets = divide(neighbours, frame, rule, groups);
            EXPECT_EQ(static_cast<int>(sets.size()), groups);
            for (const auto& set : sets) {
                EXPECT_TRUE(std::is_sorted(set.begin(), set.end()));
                all.insert(all.end(), set.begin(), set.end());
            }
            std::sort(all.begin(), all.end());
            std::vector<int> expected(103);
            std::iota(expected.begin(), expected.end(), 0);
            EXPECT_EQ(all, expected);
        }
}

TEST(Divide, DoesNotKnowTheNumbering) {
    const auto neighbours = half_ball(103);
    for (const Grouping rule : rules) {
        auto shuffled = neighbours;
        std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(3));
        EXPECT_EQ(by_place(neighbours, divide(neighbours, frame, rule, 4)), by_place(shuffled, divide(shuffled, frame, rule, 4)));
    }
}

TEST(Divide, EqualKeysAreSettledByPlace) {
    std::vector<Neighbour> ring;  // all at the same |r|
    for (int k = 0; k < 8; ++k) {
        const Eigen::Vector3d r(1, 0, k < 4 ? 0 : 0.1);
        ring.push_back({(Eigen::AngleAxisd(k * M_PI / 2 + 0.3, Eigen::Vector3d::UnitZ()) * r).normalized(), 1});
    }
    auto reversed = ring;
    std::reverse(reversed.begin(), reversed.end());
    for (const Grouping rule : rules)
        EXPECT_EQ(by_place(ring, divide(ring, frame, rule, 3)), by_place(reversed, divide(reversed, frame, rule, 3)));
}

TEST(Divide, DistanceMakesShells) {
    const auto neighbours = half_ball(60);
    const auto sets = divide(neighbours, frame, Grouping::distance, 3);
    double reached = 0;
    for (const auto& set : sets) {
        EXPECT_EQ(set.size(), 20u);
        double low = 2, high = 0;
        for (const int k : set) low = std::min(low, neighbours[k].r.norm()), high = std::max(high, neighbours[k].r.norm());
        EXPECT_GE(low, reached);
        reached = high;
    }
}

/// Four sectors of a half ball with a tangential load along y: the first faces it.
TEST(Divide, AzimuthStartsAtTheTangentialLoad) {
    const auto neighbours = half_ball(400);
    const auto sets = divide(neighbours, {Eigen::Vector3d::UnitZ(), Eigen::Vector3d(0, 2, 5)}, Grouping::azimuth, 4);
    std::array<Eigen::Vector3d, 4> mean;
    for (int g = 0; g < 4; ++g) {
        EXPECT_EQ(sets[g].size(), 100u);
        mean[g].setZero();
        for (const int k : sets[g]) mean[g] += neighbours[k].r / sets[g].size();
    }
    EXPECT_GT(mean[0].y(), 3 * std::abs(mean[0].x()));
    EXPECT_LT(mean[1].x(), -3 * std::abs(mean[1].y())) << "counted about the normal: y, then -x";
    EXPECT_LT(mean[2].y(), -3 * std::abs(mean[2].x()));
}

TEST(Divide, AzimuthTurnsWithTheBody) {
    auto neighbours = half_ball(80);
    for (auto& neighbour : neighbours) neighbour.r.x() *= 2;  // a largest extent to hold on to
    const auto before = divide(neighbours, frame, Grouping::azimuth, 3);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(2, 1, -1).normalized()).toRotationMatrix();
    for (auto& neighbour : neighbours) neighbour.r = turn * neighbour.r;
    EXPECT_EQ(divide(neighbours, {turn.col(2), Eigen::Vector3d::Zero()}, Grouping::azimuth, 3), before);
}

TEST(Divide, KMeansFindsClusters) {
    std::vector<Neighbour> neighbours;
    const std::array<Eigen::Vector3d, 3> centres{Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 1, 0), Eigen::Vector3d(0, -1, 1)};
    for (const Neighbour& one : half_ball(90)) neighbours.push_back({centres[neighbours.size() % 3] + 0.2 * one.r, one.volume});
    const auto sets = divide(neighbours, frame, Grouping::k_means, 3);
    for (const auto& set : sets) {
        ASSERT_EQ(set.size(), 30u);
        for (const int k : set) EXPECT_EQ(k % 3, set.front() % 3);
    }
}

TEST(Divide, FewerNeighboursThanGroups) {
    const auto neighbours = half_ball(2);
    for (const Grouping rule : rules) {
        std::size_t total = 0;
        for (const auto& set : divide(neighbours, frame, rule, 5)) total += set.size();
        EXPECT_EQ(total, 2u);
    }
    EXPECT_EQ(divide({}, frame, Grouping::k_means, 4).size(), 4u);
    EXPECT_THROW(divide(neighbours, frame, Grouping::azimuth, 0), std::invalid_argument);
}

}  // namespace
}  // namespace cleave::fracture
