#include "reference_fem/elasticity.hpp"
#include "reference_fem/test/error_text.hpp"
#include "reference_fem/test/materials.hpp"
#include "reference_fem/test/msh_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace cleave::fem::testing {
namespace {

/// A clamped box with one spoilt item.
Problem clamped_box(const Box& box = {}) {
    Problem problem;
    problem.mesh_file = write_box("problem.msh", box);
    problem.regions = {{1, triclinic()}};
    problem.displacements = {{1, {true, true, true}, [](const Point&) { return Point{}; }}};
    problem.tractions = {{2, [](const Point&) { return Point{1e6, 0, 0}; }}};
    return problem;
}
std::string solve_error(const Problem& problem, const Options& options = {}) {
    return error_of([&] { solve(problem, options); });
}

TEST(BadProblem, UnknownSurfaceOrRegionIsNamed) {
    Problem problem = clamped_box();
    EXPECT_EQ(solve_error(problem), "");
    problem.pressures = {{9, 1e6}};
    EXPECT_TRUE(contains(solve_error(problem), "no physical surface 9 (the mesh has: 1, 2, 3, 4, 5, 6)"));
    problem = clamped_box({.region = [](const Point& c) { return c[0] < 0.5 ? 1 : 4; }});
    EXPECT_TRUE(contains(solve_error(problem), "region 4 has no stiffness"));
    problem = clamped_box();
    problem.regions.push_back({3, triclinic()});
    EXPECT_TRUE(contains(solve_error(problem), "has no region 3"));
    problem.regions[1].id = 1;
    EXPECT_TRUE(contains(solve_error(problem), "region 1 has two stiffnesses"));
}

/// Trap: a tagged interior surface makes deal.II's create_triangulation throw. Here it does no harm until something is prescribed on it.
TEST(BadProblem, InteriorSurfaceIsIgnoredUnlessUsed) {
    MshText text = box_mesh({.counts = {2, 2, 2}, .distortion = 0});
    for (const auto& tet : text.tets) {
        std::vector<int> inner;
        for (const int node : tet.nodes)
            if (text.nodes[node][0] == 0.5) inner.push_back(node);
        if (inner.size() == 3) text.triangles.push_back({{inner[0], inner[1], inner[2]}, 70});
    }
    Problem problem = clamped_box();
    problem.mesh_file = write_temporary("interior.msh", text.version_2());
    EXPECT_EQ(solve_error(problem), "");
    problem.pressures = {{70, 1e6}};
    EXPECT_TRUE(contains(solve_error(problem), "surface 70: triangle"));
    EXPECT_TRUE(contains(solve_error(problem), "lies inside the body"));
}

/// A face may belong to several surfaces: pressure on "all sides" added to traction on one of them.
TEST(Surfaces, MayOverlap) {
    MshText text = box_mesh({});
    const std::vector<MshText::Triangle> sides = text.triangles;
    for (const auto& triangle : sides)
        if (triangle.surface == 2) text.triangles.push_back({triangle.nodes, 20});
    Problem twice = clamped_box(), once = clamped_box();
    twice.mesh_file = write_temporary("overlap.msh", text.version_2());
    twice.tractions.push_back({20, twice.tractions[0].value});
    once.tractions[0].value = [](const Point&) { return Point{2e6, 0, 0}; };
    EXPECT_NEAR(solve(twice).energy() / solve(once).energy(), 1, 1e-12);
}

TEST(BadProblem, StiffnessMustBeSymmetricPositiveDefinite) {
    Problem problem = clamped_box();
    problem.regions[0].stiffness[2][4] += 1e9;
    EXPECT_TRUE(contains(solve_error(problem), "region 1: the stiffness is not a finite symmetric matrix"));
    problem = clamped_box();
    problem.regions[0].stiffness[0][0] = NAN;
    EXPECT_TRUE(contains(solve_error(problem), "not a finite symmetric matrix"));
    problem = clamped_box();
    problem.regions[0].stiffness[3][3] = 1;
    EXPECT_TRUE(contains(solve_error(problem), "region 1: the stiffness is not positive definite"));
}

TEST(BadProblem, FreeMotionsAreCounted) {
    Problem problem = clamped_box();
    problem.displacements.clear();
    EXPECT_TRUE(contains(solve_error(problem), "the body can still move rigidly in 6 of 6 ways"));
    problem.displacements = {{1, {true, false, false}, [](const Point&) { return Point{}; }}};
    EXPECT_TRUE(contains(solve_error(problem), "in 3 of 6 ways"));
    // The classic 3-2-1 mistake: the last support on the axis of the first two leaves the turn about it.
    problem.displacements.clear();
    problem.supports = {{{0, 0, 0}, {true, true, true}, {}}, {{1, 0, 0}, {false, true, true}, {}}, {{1, 0, 0}, {false, false, true}, {}}};
    EXPECT_TRUE(contains(solve_error(problem), "in 1 of 6 ways"));
}

TEST(BadProblem, LoosePartIsLocated) {
    MshText text = box_mesh({});
    const int first = static_cast<int>(text.nodes.size());
    for (const Point& node : single_tet().nodes) text.nodes.push_back({node[0] + 5, node[1], node[2]});
    text.tets.push_back({{first, first + 1, first + 2, first + 3}, 1});
    Problem problem = clamped_box();
    problem.mesh_file = write_temporary("part.msh", text.version_2());
    EXPECT_TRUE(contains(solve_error(problem), "the part around (5.5, 0.5, 0.5) can still move rigidly in 6 of 6 ways"));
}

/// Two tets that share an edge only: each rigid-body count is fine for the whole, but the hinge turns. Found by the condition of the
/// factor.
TEST(BadProblem, HingeIsFound) {
    MshText text = single_tet();
    text.nodes.insert(text.nodes.end(), {{1, -1, 0}, {0.5, -1, 1}});
    text.tets.push_back({{0, 4, 1, 5}, 1});  // shares the edge 0-1
    text.triangles = {{{0, 1, 2}, 1}};
    Problem problem = clamped_box();
    problem.mesh_file = write_temporary("hinge.msh", text.version_2());
    problem.tractions.clear();
    EXPECT_TRUE(contains(solve_error(problem), "singular"));
}

TEST(BadProblem, ContradictionsAreLocated) {
    Problem problem = clamped_box();
    problem.displacements.push_back({3, {false, true, false}, [](const Point&) { return Point{0, 1e-3, 0}; }});
    EXPECT_TRUE(contains(solve_error(problem), "surface 3: u_y = 0.001 m at (0, 0, "));
    EXPECT_TRUE(contains(solve_error(problem), "contradicts"));
    // The same field on both sides agrees along the shared edge, up to rounding.
    problem.displacements[1].value = [](const Point& x) { return Point{0, 1e-3 * x[0] + 1e-13, 0}; };
    EXPECT_EQ(solve_error(problem), "");
}

TEST(BadProblem, ValuesAreFiniteAndPresent) {
    Problem problem = clamped_box();
    problem.tractions[0].value = [](const Point&) { return Point{NAN, 0, 0}; };
    EXPECT_TRUE(contains(solve_error(problem), "a load is not finite"));
    problem.tractions[0].value = nullptr;
    EXPECT_TRUE(contains(solve_error(problem), "surface 2: a traction without a value"));
    problem = clamped_box();
    problem.displacements[0].value = [](const Point&) { return Point{0, INFINITY, 0}; };
    EXPECT_TRUE(contains(solve_error(problem), "surface 1: a prescribed displacement is not finite"));
    problem.displacements[0].value = nullptr;
    EXPECT_TRUE(contains(solve_error(problem), "surface 1: a displacement without a value"));
}

TEST(BadProblem, OptionsAreChecked) {
    EXPECT_TRUE(contains(solve_error(clamped_box(), {.degree = 3}), "degree must be 1 or 2"));
    EXPECT_TRUE(contains(solve_error(clamped_box(), {.tolerance = 0}), "tolerance must be positive"));
    EXPECT_TRUE(contains(solve_error(clamped_box(), {.solver = Solver::iterative, .iteration_limit = 3}), "after 3 iterations"));
}

TEST(Everywhere, PrescribedDisplacementNeedsNoSolver) {
    MshText text = single_tet();
    text.triangles = {{{0, 1, 2}, 1}, {{0, 1, 3}, 1}, {{0, 2, 3}, 1}, {{1, 2, 3}, 1}};
    Problem problem = clamped_box();
    problem.mesh_file = write_temporary("held.msh", text.version_2());
    problem.tractions.clear();
    problem.displacements[0].value = [](const Point& x) { return Point{x[0], 0, 0}; };
    for (const Solver solver : {Solver::direct, Solver::iterative})
        EXPECT_NEAR(solve(problem, {.solver = solver}).at({0.2, 0.2, 0.2}).strain[0], 1, 1e-14);
}

}  // namespace
}  // namespace cleave::fem::testing
