#include "solver/particles/neighbour_search.hpp"
#include "solver/particles/test/box_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::particles {
namespace {

void expect_as_defined(const Particles& particles, const char* what) {
    const NeighbourLists found = find_neighbours(particles), defined = find_neighbours_brute_force(particles);
    EXPECT_EQ(found.offset, defined.offset) << what;
    EXPECT_EQ(found.index, defined.index) << what;
}

Particles at(const std::vector<Eigen::Vector3d>& points, double support_radius) {
    return from_points(points, std::vector<double>(points.size(), 1e-3), support_radius, 1);
}

class RandomPoints {
public:
    double uniform() { return std::uniform_real_distribution<double>(0, 1)(generator_); }
    Eigen::Vector3d place() { return {uniform(), uniform(), uniform()}; }
    Eigen::Matrix3d axes() {
        return Eigen::Quaterniond(Eigen::Vector4d(uniform(), uniform(), uniform(), 1).normalized()).toRotationMatrix();
    }

private:
    std::mt19937 generator_{11};
};

/// A lattice far from the origin whose distances equal the support to the last bit or miss it by one: single precision cannot tell, and the
/// definition has to.
TEST(NeighbourSearch, SettlesPointsOnTheEdgeByTheDefinition) {
    std::vector<Eigen::Vector3d> points;
    for (int x = 0; x < 9; ++x)
        for (int y = 0; y < 9; ++y)
            for (int z = 0; z < 9; ++z) points.emplace_back(1000 + 0.1 * x, -500 + 0.1 * y, 0.1 * z);
    for (const double radius : {0.1, 0.2, 0.3, std::sqrt(0.05)})
        for (const double nudge : {-1e-12, 0.0, 1e-12}) expect_as_defined(at(points, radius * (1 + nudge)), "lattice");
}

TEST(NeighbourSearch, EveryParticleAnotherKernel) {
    RandomPoints random;
    std::vector<Eigen::Vector3d> points(700);
    for (Eigen::Vector3d& x : points) x = random.place().cwiseProduct(Eigen::Vector3d(1, 2, 0.3));
    Particles particles = at(points, 0.1);
    for (Eigen::Matrix3d& tensor : particles.tensor) {
        const Eigen::Vector3d radii(0.05 + random.uniform(), 0.05 + random.uniform(), 0.02 + 3 * random.uniform());
        const double kind = 3 * random.uniform();
        tensor = kind < 1 ? isotropic_tensor(0.3 * radii[0])
                          : tensor_from_axes(kind < 2 ? random.axes() : Eigen::Matrix3d(Eigen::Matrix3d::Identity()), 0.3 * radii);
    }
    expect_as_defined(particles, "round, along the axes and askew, 0.006 to 0.9 long");
}

/// Halving has to end where nothing is left to halve, and where every step splits off one point only.
TEST(NeighbourSearch, HeapsOfPoints) {
    RandomPoints random;
    std::vector<Eigen::Vector3d> coincident(100, Eigen::Vector3d(0.1, 0.2, 0.3));
    expect_as_defined(at(coincident, 0.1), "all at one place");
    for (int n = 0; n < 100; ++n) coincident.push_back(random.place());
    expect_as_defined(at(coincident, 0.3), "half of them at one place");
    std::vector<Eigen::Vector3d> ever_nearer;
    for (int n = 0; n < 300; ++n) ever_nearer.emplace_back(std::pow(0.5, n), 0, std::pow(0.7, n));
    expect_as_defined(at(ever_nearer, 0.01), "ever nearer to one point");
    std::vector<Eigen::Vector3d> far;
    for (int n = 0; n < 200; ++n) far.push_back(random.place() + 1e7 * Eigen::Vector3d(n % 3, n % 2, 0));
    expect_as_defined(at(far, 0.4), "heaps so far apart that single precision sees none of their points");
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

TEST(NeighbourSearch, NothingIsLeftOfListsFoundBefore) {
    const Particles many = from_mesh(test::box_mesh(5)), some = from_mesh(test::box_mesh(3));
    NeighbourLists lists;
    NeighbourSearch search(some);
    for (int round = 0; round < 2; ++round) {
        find_neighbours(many, lists);
        search.find(lists);
        EXPECT_EQ(lists.offset, find_neighbours_brute_force(some).offset);
        EXPECT_EQ(lists.index, find_neighbours_brute_force(some).index);
    }
}

}  // namespace
}  // namespace cleave::particles
