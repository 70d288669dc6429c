#include "solver/particles/neighbour_search.hpp"
#include "solver/particles/neighbours.hpp"
#include "solver/particles/test/box_mesh.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace cleave::particles {
namespace {

std::vector<int> by_definition(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& at, const Eigen::Matrix3d& tensor, int self) {
    std::vector<int> ids;
    for (int j = 0; j < static_cast<int>(points.size()); ++j)
        if (j != self && is_inside(tensor, points[j] - at)) ids.push_back(j);
    return ids;
}

std::vector<int> by_search(NeighbourSearch& search, const Eigen::Vector3d& at, const Eigen::Matrix3d& tensor, int self) {
    std::vector<int> ids;
    search.append(at, tensor, self, ids);
    return ids;
}

/// A lattice far from the origin whose distances equal the support to the last bit or miss it by one: single precision cannot tell, and the
/// definition has to.
TEST(NeighbourSearch, SettlesPointsOnTheEdgeByTheDefinition) {
    std::vector<Eigen::Vector3d> points;
    for (int x = 0; x < 9; ++x)
        for (int y = 0; y < 9; ++y)
            for (int z = 0; z < 9; ++z) points.emplace_back(1000 + 0.1 * x, -500 + 0.1 * y, 0.1 * z);
    NeighbourSearch search(points, 0.25);
    std::size_t found = 0;
    for (const double radius : {0.1, 0.2, 0.3, std::sqrt(0.05)})
        for (const double nudge : {-1e-12, 0.0, 1e-12}) {
            const Eigen::Matrix3d tensor = isotropic_tensor(radius * (1 + nudge));
            for (int i = 0; i < static_cast<int>(points.size()); i += 7) {
                const std::vector<int> expected = by_definition(points, points[i], tensor, i);
                EXPECT_EQ(by_search(search, points[i], tensor, i), expected);
                found += expected.size();
            }
        }
    EXPECT_GT(found, 1000U) << "else this test says nothing";
}

TEST(NeighbourSearch, AnyPointAnyKernelAnyCell) {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<Eigen::Vector3d> points(700);
    for (Eigen::Vector3d& x : points) x = {uniform(generator), 2 * uniform(generator), 0.3 * uniform(generator)};
    for (const double cell : {1e-6, 0.05, 0.3, 50.0}) {
        NeighbourSearch search(points, cell);
        for (int query = 0; query < 40; ++query) {
            const Eigen::Vector3d at = 3 * Eigen::Vector3d(uniform(generator), uniform(generator), uniform(generator)) - Eigen::Vector3d::Ones();
            const Eigen::Quaterniond turn(Eigen::Vector4d(uniform(generator), uniform(generator), uniform(generator), 1).normalized());
            const Eigen::Vector3d radii(0.05 + uniform(generator), 0.05 + uniform(generator), 0.02 + 3 * uniform(generator));
            for (const Eigen::Matrix3d& tensor : {isotropic_tensor(radii[0]), tensor_from_axes(turn.toRotationMatrix(), radii),
                                                  tensor_from_axes(Eigen::Matrix3d::Identity(), radii)})
                EXPECT_EQ(by_search(search, at, tensor, -1), by_definition(points, at, tensor, -1));
        }
    }
}

/// The simple form, cell by cell and one by one, finds the same lists.
TEST(NeighbourSearch, AgreesWithTheSimpleGrid) {
    Particles particles = from_mesh(test::box_mesh(6, 0.2, test::graded(5)));
    const CellGrid grid(particles.position, suitable_cell(particles));
    const NeighbourLists lists = find_neighbours(particles);
    for (int i = 0; i < particles.size(); ++i) {
        std::vector<int> simple = neighbours_of_point(particles, grid, particles.position[i], particles.tensor[i]);
        std::erase(simple, i);
        const auto list = lists.of(i);
        EXPECT_EQ(std::vector<int>(list.begin(), list.end()), simple);
    }
}

TEST(NeighbourSearch, AppendsAndLeavesWhatIsThere) {
    const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}};
    NeighbourSearch search(points, 1);
    std::vector<int> ids{42};
    search.append({0.5, 0, 0}, isotropic_tensor(2), 1, ids);
    EXPECT_EQ(ids, (std::vector<int>{42, 0}));
}

}  // namespace
}  // namespace cleave::particles
