// Loads and holds beside the plain ones: material frames, tractions of a stress, lines, free bodies.

#include "reference_fem/elasticity.hpp"
#include "reference_fem/test/error_text.hpp"
#include "reference_fem/test/materials.hpp"
#include "reference_fem/test/msh_text.hpp"
#include "reference_fem/vector3.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::fem::testing {
namespace {

const Box even{.distortion = 0};
VectorField constant(const Point& value) {
    return [value](const Point&) { return value; };
}

Problem clamped(const std::string& name) {
    Problem problem;
    problem.mesh_file = write_box(name, even);
    problem.regions = {{.id = 1, .stiffness = triclinic()}};
    problem.displacements = {{1, {true, true, true}, constant({})}};
    return problem;
}

Problem pulled(const std::string& name) {
    Problem problem = clamped(name);
    problem.tractions = {{.surface = 2, .value = constant({1e6, -2e5, 3e5})}};
    return problem;
}

/// Rz(0.7) Ry(0.4), column by column the material axes.
Tensor2 rotation() {
    const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(0.4), t = std::sin(0.4);
    return {{{c * d, -s, c * t}, {s * d, c, s * t}, {-t, 0, d}}};
}
Frame columns(const Tensor2& r) { return {{{r[0][0], r[1][0], r[2][0]}, {r[0][1], r[1][1], r[2][1]}, {r[0][2], r[1][2], r[2][2]}}}; }

TEST(MaterialFrame, TurnsTheStiffness) {
    Problem turned = pulled("frame.msh"), given = turned, transposed = turned;
    given.regions[0].stiffness = rotated(triclinic(), rotation());
    turned.regions[0].frame = columns(rotation());
    const Tensor2 r = rotation();
    transposed.regions[0].frame = {{{r[0][0], r[0][1], r[0][2]}, {r[1][0], r[1][1], r[1][2]}, {r[2][0], r[2][1], r[2][2]}}};
    const double expected = solve(given).energy();
    EXPECT_NEAR(solve(turned).energy() / expected, 1, 1e-12);
    EXPECT_GT(std::abs(solve(transposed).energy() / expected - 1), 1e-3);  // the classic mistake is seen
}

TEST(MaterialFrame, MustBeOrthonormalAndRightHanded) {
    Problem problem = pulled("frame_bad.msh");
    problem.regions[0].frame = {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}};
    EXPECT_TRUE(contains(error_of([&] { solve(problem); }), "region 1: the material axes are not orthonormal and right-handed"));
    problem.regions[0].frame = {{{1, 0, 0}, {1e-6, 1, 0}, {0, 0, 1}}};
    EXPECT_TRUE(contains(error_of([&] { solve(problem); }), "not orthonormal"));
}

TEST(Traction, OfAStressIsStressTimesOutwardNormal) {
    // Low and high side: the normals are (0, -1, 0) and (0, 1, 0); the middle column of the stress.
    Problem by_stress = clamped("stress.msh"), by_vector = by_stress;
    const StressField stress = [](const Point& x) { return Voigt{9, (1 + x[0]) * 1e6, 8, -3e5, 7, 2e5}; };
    by_stress.tractions = {{.surface = 3, .stress = stress}, {.surface = 4, .stress = stress}};
    const auto column = [](double sign) { return [sign](const Point& x) { return sign * Point{2e5, (1 + x[0]) * 1e6, -3e5}; }; };
    by_vector.tractions = {{.surface = 3, .value = column(-1)}, {.surface = 4, .value = column(1)}};
    EXPECT_NEAR(solve(by_stress).energy() / solve(by_vector).energy(), 1, 1e-12);
    by_stress.tractions[0].value = column(-1);
    EXPECT_TRUE(contains(error_of([&] { solve(by_stress); }), "surface 3: a traction with both value and stress"));
}

/// Work of a load A on the displacement of B: U(A + B) - U(A) - U(B). Held against an integral of u along the line, exact by Simpson's
/// rule on each edge of quadratic elements.
TEST(LineLoad, DoesItsWorkAlongTheLine) {
    for (const int degree : {1, 2}) {
        const Options options{.degree = degree};
        const Line line{2, 4};  // x = 1, y = 1
        const auto force = [](const Point& x) { return Point{1e5 * (1 + x[2]), 2e5, -3e5 * x[2]}; };
        Problem both = pulled("line.msh"), only_line = clamped("line.msh");
        both.line_loads = only_line.line_loads = {{line, force}};
        const Solution alone = solve(pulled("line.msh"), options);
        const double work = solve(both, options).energy() - solve(only_line, options).energy() - alone.energy();
        double expected = 0;
        const int edges = even.counts[2], parts = 12 * edges;  // Simpson on four parts of each edge: the integrand is cubic
        for (int i = 0; i <= parts; ++i) {
            const Point x{1, 1, static_cast<double>(i) / parts};
            const double weight = i == 0 || i == parts ? 1 : i % 2 == 1 ? 4 : 2;
            expected += weight / (3.0 * parts) * dot(force(x), alone.at(x).displacement);
        }
        EXPECT_NEAR(work / expected, 1, 1e-9) << degree;
    }
}

TEST(LineDisplacement, HoldsEveryNodeOfTheLine) {
    Problem problem = pulled("held_line.msh");
    problem.line_displacements = {{{4, 6}, {false, false, true}, constant({0, 0, 1e-4})}};  // y = 1, z = 1
    problem.displacements[0].value = constant({0, 0, 1e-4});
    const Solution solution = solve(problem);
    for (const double x : {0.2, 0.5, 0.9, 1.0}) EXPECT_NEAR(solution.at({x, 1, 1}).displacement[2], 1e-4, 1e-16);
    EXPECT_GT(std::abs(solution.at({0.9, 0.9, 1}).displacement[2] - 1e-4), 1e-6);  // beside the line the body is free
}

TEST(Lines, MistakesAreNamed) {
    Problem problem = pulled("line_bad.msh");
    problem.line_loads = {{{3, 4}, constant({1, 0, 0})}};
    EXPECT_TRUE(contains(error_of([&] { solve(problem); }), "the surfaces 3 and 4 do not meet in a line"));
    problem.line_loads = {{{2, 4}, constant({NAN, 0, 0})}};
    EXPECT_TRUE(contains(error_of([&] { solve(problem); }), "line of the surfaces 2 and 4: a load is not finite"));
    problem.line_loads = {{{2, 4}, {}}};
    EXPECT_TRUE(contains(error_of([&] { solve(problem); }), "line of the surfaces 2 and 4: a load without a value"));
}

Problem flying(const std::string& name) {
    Problem problem = pulled(name);
    problem.displacements.clear();
    problem.pressures = {{6, 4e5}};
    problem.regions[0].density = 2600;
    problem.free_body = true;
    return problem;
}

/// Rigid accelerations drop out: adding rho times any rigid motion as a body force changes nothing.
TEST(FreeBody, IsBlindToRigidAcceleration) {
    const Problem problem = flying("free.msh");
    Problem swung = problem;
    swung.body_force = [](const Point& x) { return 2600.0 * (Point{300, -200, 100} + cross({40, 50, -60}, x)); };
    EXPECT_NEAR(solve(swung).energy() / solve(problem).energy(), 1, 1e-9);
    swung.body_force = [](const Point& x) { return Point{2600 * 1000 * x[0] * x[0], 0, 0}; };
    EXPECT_GT(std::abs(solve(swung).energy() / solve(problem).energy() - 1), 1e-3);
}

TEST(FreeBody, HasNeitherLinearNorAngularMomentum) {
    Point linear{}, angular{};
    double size = 0;
    for (const FieldSample& sample : solve(flying("momentum.msh")).quadrature_samples(4)) {
        linear = linear + sample.weight * sample.displacement;
        angular = angular + sample.weight * cross(sample.position, sample.displacement);
        size += sample.weight * norm(sample.displacement);
    }
    EXPECT_LT(norm(linear), 1e-12 * size);
    EXPECT_LT(norm(angular), 1e-12 * size);
}

TEST(FreeBody, MistakesAreNamed) {
    Problem problem = flying("free_bad.msh");
    problem.regions[0].density = 0;
    EXPECT_TRUE(contains(error_of([&] { solve(problem); }), "region 1: a free body needs a density"));
    problem = flying("free_bad.msh");
    problem.supports = {{{0, 0, 0}, {true, false, false}, {}}};
    EXPECT_TRUE(contains(error_of([&] { solve(problem); }), "a free body cannot have prescribed displacements"));
}

}  // namespace
}  // namespace cleave::fem::testing
