// Trap: deal.II's own point search returns wrong cells on tets (deal_ii_traps_test.cpp shows it), so ours is tested hard.

#include "reference_fem/point_locator.hpp"

#include "reference_fem/elasticity.hpp"
#include "reference_fem/test/gmsh_body.hpp"
#include "reference_fem/test/materials.hpp"
#include "reference_fem/test/msh_text.hpp"
#include "reference_fem/vector3.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace cleave::fem::testing {
namespace {

struct Planted {
    int cell;
    Point point;
};

/// Points inside known cells, uniform in a random cell (spacings of three sorted numbers). With this seed none comes within the
/// locator's slack of 1e-9 of a face, where the neighbour would be as right.
std::vector<Planted> plant(const Mesh& mesh, int count) {
    std::mt19937 random(5);
    std::vector<Planted> planted;
    const auto uniform = [&] { return (random() + 0.5) / 4294967296.0; };
    while (count-- > 0) {
        const int cell = static_cast<int>(random() % mesh.cells.size());
        std::array<double, 3> cuts{uniform(), uniform(), uniform()};
        std::sort(cuts.begin(), cuts.end());
        const std::array<double, 4> weights{cuts[0], cuts[1] - cuts[0], cuts[2] - cuts[1], 1 - cuts[2]};
        Point point{};
        for (int i = 0; i < 4; ++i) point = point + weights[i] * mesh.vertices[mesh.cells[cell][i]];
        planted.push_back({cell, point});
    }
    return planted;
}

int wrong_cells(const Mesh& mesh) {
    const PointLocator locator(mesh, 0.1);
    int wrong = 0;
    for (const auto& [cell, point] : plant(mesh, 20000)) {
        const auto place = locator.find(point);
        wrong += !place || place->cell != cell;
    }
    return wrong;
}

TEST(PointLocator, NoneOf20000WrongInABox) { EXPECT_EQ(wrong_cells(read_msh(write_box("a.msh", {.counts = {10, 10, 10}}))), 0); }

/// Bricks of 1 : 20 : 100.
TEST(PointLocator, NoneOf20000WrongInAFlatBox) {
    EXPECT_EQ(wrong_cells(read_msh(write_box("b.msh", {.high = {1, 20, 100}, .counts = {9, 9, 9}}))), 0);
}

/// Unstructured and graded 1 : 20 towards a hole.
TEST(PointLocator, NoneOf20000WrongInAGmshMesh) { EXPECT_EQ(wrong_cells(read_msh(quarter_plate_with_hole("c.msh"))), 0); }

TEST(PointLocator, UnitCoordinatesGiveThePointBack) {
    const Mesh mesh = read_msh(write_box("d.msh", {}));
    const PointLocator locator(mesh, 0);
    for (const auto& [cell, point] : plant(mesh, 100)) {
        const auto place = locator.find(point);
        const Point& origin = mesh.vertices[mesh.cells[cell][0]];
        Point back = origin;
        for (int i = 0; i < 3; ++i) back = back + place->unit[i] * (mesh.vertices[mesh.cells[cell][i + 1]] - origin);
        EXPECT_LT(norm(back - point), 1e-14);
    }
}

TEST(PointLocator, SharedPlacesBelongToTheFirstCell) {
    const Mesh mesh = read_msh(write_box("e.msh", {}));
    const PointLocator locator(mesh, 0.1);
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
        int first = 0;
        while (std::find(mesh.cells[first].begin(), mesh.cells[first].end(), static_cast<int>(vertex)) == mesh.cells[first].end()) ++first;
        EXPECT_EQ(locator.find(mesh.vertices[vertex])->cell, first);
    }
}

TEST(PointLocator, OutsidePointsCountUpToTheTolerance) {
    // Undistorted bricks of edge 1/2: every tet has the diameter sqrt(3)/2.
    const Mesh mesh = read_msh(write_box("f.msh", {.counts = {2, 2, 2}, .distortion = 0}));
    const double tenth = 0.1 * std::sqrt(3.0) / 2;
    const PointLocator locator(mesh, 0.1), strict(mesh, 0);
    EXPECT_TRUE(locator.find({1 + 0.99 * tenth, 0.4, 0.3}));
    EXPECT_FALSE(locator.find({1 + 1.01 * tenth, 0.4, 0.3}));
    EXPECT_FALSE(strict.find({1 + 1e-6, 0.4, 0.3}));
    EXPECT_TRUE(strict.find({1 + 1e-10, 0.4, 0.3}));
    EXPECT_FALSE(locator.find({NAN, 0.4, 0.3}));
}

TEST(Solution, EvaluatesOutsideOnlyWithinTheTolerance) {
    Problem problem;
    problem.mesh_file = write_box("g.msh", {.counts = {2, 2, 2}, .distortion = 0});
    problem.regions = {{1, triclinic()}};
    for (int side = 1; side <= 6; ++side)
        problem.displacements.push_back({side, {true, true, true}, [](const Point& x) { return 1e-3 * x; }});
    const Solution solution = solve(problem);
    EXPECT_NEAR(solution.at({1.05, 0.4, 0.3}).displacement[0], 1.05e-3, 1e-15);  // the cell's polynomial, continued
    EXPECT_THROW(solution.at({1.2, 0.4, 0.3}), Error);
    EXPECT_THROW(solution.recovered_at({{1.2, 0.4, 0.3}}), Error);
}

}  // namespace
}  // namespace cleave::fem::testing
