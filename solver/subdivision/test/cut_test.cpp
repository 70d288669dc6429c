#include "solver/subdivision/cut.hpp"

#include "solver/mesh/test/test_meshes.hpp"
#include "solver/subdivision/test/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace cleave::subdivision {
namespace {

using Eigen::Vector3d;

TEST(ShortestEdges, OfTheUnitTet) {
    mesh::TetMesh mesh = mesh::test::unit_tet();
    mesh.vertices.emplace_back(5, 5, 5);  // unused
    const std::vector<double> shortest = shortest_incident_edges(mesh);
    EXPECT_EQ(shortest, (std::vector<double>{1, 1, 1, 1, std::numeric_limits<double>::infinity()}));
}

TEST(VertexDistances, SignsAndTheRaise) {
    const std::vector<Vector3d> points{{0, 0, 0}, {0, 0, 1e-5}, {0, 0, -1e-5}, {0, 0, 0.3}, {0, 0, -0.3}};
    const std::vector<double> edges(5, 2.0);
    const Cut cut{.centre = Vector3d::Zero(), .normal = {0, 0, 7}};
    EXPECT_EQ(vertex_distances(points, edges, cut, 0.1), (std::vector<double>{0.2, 0.2, -0.2, 0.3, -0.3}));
    EXPECT_EQ(vertex_distances(points, edges, cut, 0.0), (std::vector<double>{0, 1e-5, -1e-5, 0.3, -0.3}));
}

TEST(VertexDistances, RefuseNonsense) {
    const std::vector<Vector3d> points{{0, 0, 0}};
    const std::vector<double> edges{1.0};
    EXPECT_THROW(vertex_distances(points, edges, {.normal = Vector3d::Zero()}, 0.1), std::invalid_argument);
    EXPECT_THROW(vertex_distances(points, edges, {.normal = {std::nan(""), 0, 0}}, 0.1), std::invalid_argument);
    EXPECT_THROW(vertex_distances(points, edges, {.radius = 0}, 0.1), std::invalid_argument);
    EXPECT_THROW(vertex_distances(points, edges, {.radius = std::nan("")}, 0.1), std::invalid_argument);
    EXPECT_THROW(vertex_distances(points, edges, {}, 0.5), std::invalid_argument);
    EXPECT_THROW(vertex_distances(points, edges, {}, -0.1), std::invalid_argument);
}

TEST(DistanceToTriangle, AgreesWithSamplesOfTheTriangle) {
    test::Random random(11);
    for (int round = 0; round < 200; ++round) {
        const Vector3d a = random.in_cube(-1, 1), b = random.in_cube(-1, 1), c = random.in_cube(-1, 1), p = random.in_cube(-2, 2);
        double nearest = 1e9;
        constexpr int steps = 60;
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; j <= steps - i; ++j) {
                nearest = std::min(nearest, (a + (b - a) * i / steps + (c - a) * j / steps - p).norm());
            }
        }
        const double distance = distance_to_triangle(p, a, b, c);
        EXPECT_LE(distance, nearest + 1e-14);
        // The nearest sample lies within one grid cell (edges up to 2 sqrt 3 long) of the nearest point.
        EXPECT_GE(distance, nearest - 2 * std::sqrt(3.0) / steps);
    }
}

TEST(Passes, DiscReachesAsFarAsItsRadius) {
    const std::array<Vector3d, 4> corners{Vector3d(0, 0, -1), Vector3d(1, 0, 1), Vector3d(0, 1, 1), Vector3d(-1, -1, 1)};
    const std::array<double, 4> distances{-1, 1, 1, 1};  // the plane z = 0: cut points at (0.5, 0), (0, 0.5), (-0.5, -0.5)
    Cut cut{.centre = {2.5, 0, 0}, .normal = {0, 0, 1}, .radius = 1.99};
    EXPECT_FALSE(passes(cut, corners, distances));
    cut.radius = 2.01;
    EXPECT_TRUE(passes(cut, corners, distances));
    cut.radius = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(passes(cut, corners, distances));
    EXPECT_FALSE(passes(cut, corners, {1, 1, 1, 1}));
    cut = {.centre = Vector3d::Zero(), .normal = {0, 0, 1}, .radius = 1e-9};  // inside the polygon
    EXPECT_TRUE(passes(cut, corners, distances));
}

}  // namespace
}  // namespace cleave::subdivision
