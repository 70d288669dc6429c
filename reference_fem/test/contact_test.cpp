// A square punch and a sphere on the top of a box of bricks: scaling laws and independence of the box, not accuracy (which is a matter of
// validation/cases/indentation_*.toml).

#include "reference_fem/contact.hpp"

#include "reference_fem/elasticity.hpp"
#include "reference_fem/test/error_text.hpp"
#include "reference_fem/test/materials.hpp"
#include "reference_fem/test/msh_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::fem::testing {
namespace {

/// A box of half width and depth `bricks`, bricks of edge 1; contact (7): the square |x|, |y| <= square on the top; outer (8): all but the top.
std::string block(int bricks, double square) {
    const double w = bricks;
    MshText text = box_mesh({.low = {-w, -w, -w}, .high = {w, w, 0}, .counts = {2 * bricks, 2 * bricks, bricks}, .distortion = 0});
    for (auto& triangle : text.triangles) {
        const bool top = triangle.surface == 6;
        bool inside = true;
        for (const int node : triangle.nodes)
            inside = inside && std::abs(text.nodes[node][0]) <= square && std::abs(text.nodes[node][1]) <= square;
        triangle.surface = !top ? 8 : inside ? 7 : 6;
    }
    return write_temporary("contact.msh", text.version_2());
}

Indentation punch(int bricks) {
    Indentation problem;
    problem.mesh_file = block(bricks, 1);
    problem.regions = {{.id = 1, .stiffness = triclinic()}};
    problem.contact = 7;
    problem.outer = 8;
    problem.radius = 1;
    problem.depth = 1e-3;
    return problem;
}

Indentation sphere() {
    Indentation problem = punch(4);
    problem.mesh_file = block(4, 2);
    problem.shape = Indentation::Shape::sphere;
    problem.radius = 1000;
    problem.depth = 0;
    problem.force = 8e8;
    return problem;
}

const Options linear{.degree = 1};

/// The far field must not see the box: its width is changed by half. What is left out falls like the third power of contact over box: 1.1 / 4^3
/// less 1.1 / 6^3, 1.2 %. With the outer surface held instead, the force depends on the box like the first power, by a tenth.
TEST(FarField, DoesNotFeelTheBox) {
    EXPECT_NEAR(solve_indentation(punch(4)).force / solve_indentation(punch(6)).force, 1, 0.015);
    const auto held = [](int bricks) {
        const Indentation of = punch(bricks);
        Problem problem;
        problem.mesh_file = of.mesh_file;
        problem.regions = of.regions;
        problem.displacements = {{8, {true, true, true}, [](const Point&) { return Point{}; }},
                                 {7, {false, false, true}, [&](const Point&) { return Point{0, 0, -of.depth}; }}};
        return 2 * solve(problem).energy() / of.depth;  // the force does work on the depth only
    };
    EXPECT_GT(held(4) / held(6), 1.08);
}

TEST(Punch, ForceIsProportionalToDepthAndIsTheWork) {
    Indentation problem = punch(4);
    const IndentationResult once = solve_indentation(problem, linear);
    problem.depth *= 2;
    const IndentationResult twice = solve_indentation(problem, linear);
    EXPECT_NEAR(twice.force / once.force, 2, 1e-9);
    EXPECT_LT(once.solution.record().relative_residual, 1e-10);
    EXPECT_NEAR(once.solution.at({0.4, -0.3, 0}).displacement[2], -1e-3, 1e-15);
}

/// Stiffness and force doubled: the same contact, to rounding.
TEST(Sphere, ScalesWithTheStiffness) {
    const IndentationResult soft = solve_indentation(sphere(), linear);
    Indentation problem = sphere();
    problem.force *= 2;
    for (auto& row : problem.regions[0].stiffness)
        for (double& entry : row) entry *= 2;
    const IndentationResult stiff = solve_indentation(problem, linear);
    EXPECT_NEAR(soft.force, 8e8, 1e-2);
    EXPECT_NEAR(stiff.depth / soft.depth, 1, 1e-9);
    EXPECT_NEAR(stiff.contact_radius / soft.contact_radius, 1, 1e-9);
    EXPECT_NEAR(stiff.peak_pressure / soft.peak_pressure, 2, 1e-8);
    double force = 0;
    for (const PressureSample& sample : soft.pressure) {
        EXPECT_GT(sample.pressure, 0);
        force += sample.area * sample.pressure;
    }
    EXPECT_NEAR(force, 8e8, 8e8 * 1e-3);  // the pressure is the force
}

/// The top stays below the sphere. Linear elements of size h meet a paraboloid to h^2 / (8 R), less than a twentieth of the depth here.
TEST(Sphere, IsNotPenetrated) {
    const Indentation problem = sphere();
    const IndentationResult result = solve_indentation(problem, linear);
    const double allowed = 1 / (8 * problem.radius);
    EXPECT_LT(allowed, 0.07 * result.depth);
    for (double x = -2; x <= 2; x += 0.25)
        for (double y = -2; y <= 2; y += 0.25) {
            const double gap = (x * x + y * y) / (2 * problem.radius) - result.depth - result.solution.at({x, y, 0}).displacement[2];
            EXPECT_GT(gap, -allowed) << x << " " << y;
        }
}

TEST(Indentation, MistakesAreNamed) {
    Indentation problem = punch(4);
    problem.depth = 0;
    EXPECT_TRUE(contains(error_of([&] { solve_indentation(problem, linear); }), "a punch needs a positive depth"));
    problem = sphere();
    problem.force = 0;
    EXPECT_TRUE(contains(error_of([&] { solve_indentation(problem, linear); }), "a sphere needs a positive force"));
    problem.force = 1e10;
    EXPECT_TRUE(contains(error_of([&] { solve_indentation(problem, linear); }), "the contact reaches the rim of its surface"));
}

}  // namespace
}  // namespace cleave::fem::testing
