// Linear fields are in the element's space, so every way of loading must give them back to rounding: 1e-10 is 1e5 roundings of slack.

#include "reference_fem/elasticity.hpp"
#include "reference_fem/test/materials.hpp"
#include "reference_fem/test/msh_text.hpp"

#include <gtest/gtest.h>

#if defined(DEAL_II_PACKAGE_NAME) || defined(BOOST_NO_AUTO_PTR)
#error "deal.II leaks out of reference_fem, by a header or by a flag"
#endif

#include <algorithm>
#include <cmath>
#include <utility>

namespace cleave::fem::testing {
namespace {

constexpr double exact = 1e-10;
const Tensor2 gradient{{{1.1e-3, -0.4e-3, 0.7e-3}, {0.9e-3, -1.3e-3, 0.2e-3}, {-0.5e-3, 0.6e-3, 0.8e-3}}};
const Point outward[6]{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};

Point linear(const Point& x) { return times(gradient, x); }

/// Supports at three corners of the unit cube that take the rigid motion of `field` and nothing else.
std::vector<Support> three_two_one(const VectorField& field) {
    const Point origin{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0};
    return {{origin, {true, true, true}, field(origin)}, {x, {false, true, true}, field(x)}, {y, {false, false, true}, field(y)}};
}

Problem held_everywhere(const std::string& mesh) {
    Problem problem;
    problem.mesh_file = mesh;
    problem.regions = {{1, triclinic()}};
    for (int side = 1; side <= 6; ++side) problem.displacements.push_back({side, {true, true, true}, linear});
    return problem;
}

Problem loaded_by_traction(const std::string& mesh) {
    Problem problem = held_everywhere(mesh);
    problem.displacements.clear();
    const Tensor2 stress = stress_tensor(triclinic(), gradient);
    for (int side = 1; side <= 6; ++side)
        problem.tractions.push_back({side, [stress, normal = outward[side - 1]](const Point&) { return times(stress, normal); }});
    problem.supports = three_two_one(linear);
    return problem;
}

/// Largest error over quadrature points of displacement and stress, each relative to its largest exact value.
struct Errors {
    double displacement = 0;
    double stress = 0;
};
Errors errors(const std::vector<FieldSample>& samples, const Tensor2& exact_gradient, const Stiffness& stiffness) {
    const Tensor2 exact_stress = stress_tensor(stiffness, exact_gradient);
    double largest_displacement = 0, largest_stress = 0;
    Errors found;
    for (const FieldSample& sample : samples) {
        const Point u = times(exact_gradient, sample.position);
        for (int i = 0; i < 3; ++i) {
            largest_displacement = std::max(largest_displacement, std::abs(u[i]));
            found.displacement = std::max(found.displacement, std::abs(sample.displacement[i] - u[i]));
        }
        for (int p = 0; p < 6; ++p) {
            const double value = exact_stress[voigt_pairs[p][0]][voigt_pairs[p][1]];
            largest_stress = std::max(largest_stress, std::abs(value));
            found.stress = std::max(found.stress, std::abs(sample.stress[p] - value));
        }
    }
    return {found.displacement / largest_displacement, found.stress / largest_stress};
}

class Patch : public ::testing::TestWithParam<int> {
protected:
    Options options() const { return {.degree = GetParam()}; }
};
INSTANTIATE_TEST_SUITE_P(Degree, Patch, ::testing::Values(1, 2));

TEST_P(Patch, PrescribedDisplacementIsExact) {
    const Solution solution = solve(held_everywhere(write_box("patch.msh", {})), options());
    const Errors found = errors(solution.quadrature_samples(2), gradient, triclinic());
    EXPECT_LT(found.displacement, exact);
    EXPECT_LT(found.stress, exact);
}

TEST_P(Patch, TractionIsExact) {
    const Solution solution = solve(loaded_by_traction(write_box("patch.msh", {})), options());
    const Errors found = errors(solution.quadrature_samples(2), gradient, triclinic());
    EXPECT_LT(found.displacement, exact);
    EXPECT_LT(found.stress, exact);
}

TEST_P(Patch, MixedConditionsAreExact) {
    Problem problem = loaded_by_traction(write_box("patch.msh", {}));
    problem.supports.clear();
    problem.tractions.erase(problem.tractions.begin());
    problem.displacements = {{1, {true, true, true}, linear}, {4, {false, true, false}, linear}};
    const Errors found = errors(solve(problem, options()).quadrature_samples(2), gradient, triclinic());
    EXPECT_LT(found.displacement, exact);
    EXPECT_LT(found.stress, exact);
}

TEST_P(Patch, WrongTractionIsSeen) {
    Problem problem = loaded_by_traction(write_box("patch.msh", {}));
    // The order of deal.II's symmetric tensors (.., xy, xz, yz) in place of ours: the stress of a stiffness with yz and xy exchanged.
    for (auto& row : problem.regions[0].stiffness) std::swap(row[3], row[5]);
    std::swap(problem.regions[0].stiffness[3], problem.regions[0].stiffness[5]);
    EXPECT_GT(errors(solve(problem, options()).quadrature_samples(2), gradient, triclinic()).displacement, 1e-2);
}

/// Uniform pressure p gives the stress -p I, so the strain -p S (1, 1, 1, 0, 0, 0): tested by the stress alone, and the sign by the volume.
TEST_P(Patch, PressureGivesHydrostaticStress) {
    Problem problem = held_everywhere(write_box("patch.msh", {}));
    problem.displacements.clear();
    for (int side = 1; side <= 6; ++side) problem.pressures.push_back({side, 2e6});
    problem.supports = three_two_one([](const Point&) { return Point{}; });
    const Solution solution = solve(problem, options());
    for (const FieldSample& sample : solution.quadrature_samples(1)) {
        for (int p = 0; p < 6; ++p) EXPECT_NEAR(sample.stress[p], p < 3 ? -2e6 : 0, 2e6 * exact);
        EXPECT_LT(sample.strain[0] + sample.strain[1] + sample.strain[2], 0);
    }
}

TEST_P(Patch, VertexDisplacementsAreThoseOfTheField) {
    const Solution solution = solve(held_everywhere(write_box("patch.msh", {})), options());
    const std::vector<Point> vertices = solution.vertices(), displacements = solution.vertex_displacements();
    ASSERT_EQ(vertices.size(), 64u);
    ASSERT_EQ(displacements.size(), vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(displacements[i][j], linear(vertices[i])[j], 1e-3 * exact);
}

/// Two triclinic materials under a piecewise linear field: gradient jump a (x) n with the acoustic tensor, (n C1 n) a = -(C1 - C0) :
/// gradient n, which makes the traction continuous across the plane z = 1/2.
TEST_P(Patch, LaminateIsExact) {
    const Stiffness lower = triclinic(), upper = triclinic(77);
    const Tensor2 lower_stress = stress_tensor(lower, gradient), upper_stress = stress_tensor(upper, gradient);
    Tensor2 acoustic{};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) acoustic[i][k] = upper[voigt_of[i][2]][voigt_of[k][2]];
    const Point jump = [&] {  // Cramer's rule
        const Point right{lower_stress[0][2] - upper_stress[0][2], lower_stress[1][2] - upper_stress[1][2],
                          lower_stress[2][2] - upper_stress[2][2]};
        const auto determinant = [](const Tensor2& m) {
            return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                   m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
        };
        Point result{};
        for (int column = 0; column < 3; ++column) {
            Tensor2 replaced = acoustic;
            for (int row = 0; row < 3; ++row) replaced[row][column] = right[row];
            result[column] = determinant(replaced) / determinant(acoustic);
        }
        return result;
    }();
    const VectorField field = [&](const Point& x) {
        Point u = linear(x);
        for (int i = 0; i < 3; ++i) u[i] += x[2] > 0.5 ? jump[i] * (x[2] - 0.5) : 0;
        return u;
    };
    Tensor2 upper_gradient = gradient;
    for (int i = 0; i < 3; ++i) upper_gradient[i][2] += jump[i];

    // Four bricks along z, undistorted: the plane z = 1/2 is made of faces.
    const Box box{.counts = {3, 3, 4}, .distortion = 0, .region = [](const Point& c) { return c[2] < 0.5 ? 1 : 2; }};
    Problem problem = held_everywhere(write_box("laminate.msh", box));
    problem.regions = {{1, lower}, {2, upper}};
    for (Displacement& displacement : problem.displacements) displacement.value = field;
    const Solution solution = solve(problem, options());
    const auto check = [&](const std::vector<FieldSample>& samples) {
        for (const FieldSample& sample : samples) {
            const Tensor2 stress = sample.region == 1 ? lower_stress : stress_tensor(upper, upper_gradient);
            for (int p = 0; p < 6; ++p) ASSERT_NEAR(sample.stress[p], stress[voigt_pairs[p][0]][voigt_pairs[p][1]], 1e8 * exact);
        }
    };
    check(solution.quadrature_samples(1));
    // Recovery must not smear the jump: points close to the plane, on both sides.
    check(solution.recovered_at({{0.4, 0.3, 0.499}, {0.4, 0.3, 0.501}, {0, 0, 0.49}, {1, 1, 0.51}}));
}

TEST_P(Patch, RepeatsGiveTheSameBits) {
    const Problem problem = loaded_by_traction(write_box("patch.msh", {}));
    const auto first = solve(problem, options()).quadrature_samples(1), second = solve(problem, options()).quadrature_samples(1);
    for (std::size_t i = 0; i < first.size(); ++i) ASSERT_EQ(first[i].stress, second[i].stress);
}

}  // namespace
}  // namespace cleave::fem::testing
