#include "reference_fem/elasticity.hpp"
#include "reference_fem/test/materials.hpp"
#include "reference_fem/test/msh_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::fem::testing {
namespace {

/// Engineering constants to stiffness, through the inverse of the 3x3 compliance block (Cramer's rule); shear moduli yz, xz, xy.
Stiffness orthotropic(const std::array<double, 3>& young, double nu_xy, double nu_yz, double nu_xz, const std::array<double, 3>& shear) {
    // Minor Poisson ratios: S12 = -nu_xy / Ey, S23 = -nu_yz / Ez, S13 = -nu_xz / Ez.
    const Tensor2 s{{{1 / young[0], -nu_xy / young[1], -nu_xz / young[2]},
                     {-nu_xy / young[1], 1 / young[1], -nu_yz / young[2]},
                     {-nu_xz / young[2], -nu_yz / young[2], 1 / young[2]}}};
    const auto minor = [&](int i, int j) {
        const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
        return s[a][c] * s[b][d] - s[a][d] * s[b][c];
    };
    const double determinant = s[0][0] * minor(0, 0) + s[0][1] * minor(0, 1) + s[0][2] * minor(0, 2);
    Stiffness stiffness{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) stiffness[i][j] = minor(j, i) / determinant;
        stiffness[3 + i][3 + i] = shear[i];
    }
    return stiffness;
}

Point zero(const Point&) { return {}; }

VectorField constant(const Point& value) {
    return [value](const Point&) { return value; };
}

Problem box_problem(const std::string& mesh, const Stiffness& stiffness) {
    Problem problem;
    problem.mesh_file = mesh;
    problem.regions = {{1, stiffness}};
    return problem;
}

/// Clamped at x = 0, pulled and sheared at x = 1, with weight: nothing about the field is simple.
Problem cantilever(const std::string& mesh, const Stiffness& stiffness) {
    Problem problem = box_problem(mesh, stiffness);
    problem.displacements = {{1, {true, true, true}, zero}};
    problem.tractions = {{2, constant({1e6, -2e5, 3e5})}};
    problem.body_force = [](const Point& x) { return Point{1e5 * x[1], -2e5, 3e5 * x[0]}; };
    return problem;
}

/// ANSYS Verification Manual, VM145, "Stretching of an Orthotropic Solid"; psi and inches stand for Pa and m.
/// By hand: eps_x = 100/10e6 - 0.1 * 200/20e6 = 9e-6, eps_y = 200/20e6 - 0.1 * 100/20e6 = 9.5e-6, eps_z = -(0.3 * 100 + 0.2 * 200)/40e6 =
/// -1.75e-6.
TEST(OrthotropicBrick, MovesAsInVm145) {
    const Stiffness stiffness = orthotropic({10e6, 20e6, 40e6}, 0.1, 0.2, 0.3, {10e6, 10e6, 10e6});
    Problem problem = box_problem(write_box("vm145.msh", {}), stiffness);
    problem.displacements = {{1, {true, false, false}, zero}, {3, {false, true, false}, zero}, {5, {false, false, true}, zero}};
    problem.tractions = {{2, constant({100, 0, 0})}, {4, constant({0, 200, 0})}};
    const FieldSample corner = solve(problem).at({1, 1, 1});
    EXPECT_NEAR(corner.displacement[0], 9e-6, 9e-14);
    EXPECT_NEAR(corner.displacement[1], 9.5e-6, 9e-14);
    EXPECT_NEAR(corner.displacement[2], -1.75e-6, 9e-14);
}

/// Pure shear stress on one pair of sides and its complement; the shear strain is stress / modulus, one modulus per plane.
double shear_strain(int voigt, const Stiffness& stiffness) {
    const auto [a, b] = voigt_pairs[voigt];
    const double stress = 1e6;
    Problem problem = box_problem(write_box("shear.msh", {}), stiffness);
    for (const auto& [normal, direction] : {std::pair{a, b}, std::pair{b, a}})
        for (const int sign : {-1, 1}) {
            Point traction{};
            traction[direction] = sign * stress;
            problem.tractions.push_back({2 * normal + (sign > 0 ? 2 : 1), constant(traction)});
        }
    problem.supports = {{{0, 0, 0}, {true, true, true}, {}}, {{1, 0, 0}, {false, true, true}, {}}, {{0, 1, 0}, {false, false, true}, {}}};
    return solve(problem).at({0.4, 0.5, 0.6}).strain[voigt];
}

TEST(SimpleShear, EachPlaneHasItsModulus) {
    const Stiffness stiffness = orthotropic({10e9, 20e9, 40e9}, 0.1, 0.2, 0.3, {3e9, 5e9, 7e9});
    EXPECT_NEAR(shear_strain(3, stiffness) * 3e9, 1e6, 1e-3);
    EXPECT_NEAR(shear_strain(4, stiffness) * 5e9, 1e6, 1e-3);
    EXPECT_NEAR(shear_strain(5, stiffness) * 7e9, 1e6, 1e-3);
}

TEST(SimpleShear, TensorShearInPlaceOfEngineeringShearIsSeen) {
    Stiffness mistaken = orthotropic({10e9, 20e9, 40e9}, 0.1, 0.2, 0.3, {3e9, 5e9, 7e9});
    for (int i = 3; i < 6; ++i) mistaken[i][i] *= 2;  // sigma = 2 G eps with eps taken for gamma
    EXPECT_GT(std::abs(shear_strain(5, mistaken) * 7e9 / 1e6 - 1), 0.4);
}

/// The same body seen in turned axes: displacements must turn with it. Rounding and the condition of the matrix leave about 1e-12.
TEST(Rotation, TurnsTheDisplacement) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    const Tensor2 rotation{{{c * c, -s, c * s}, {s * c, c, s * s}, {-s, 0, c}}};  // Rz(0.7) Ry(0.7)
    const MshText straight = box_mesh({});
    MshText turned = straight;
    for (Point& node : turned.nodes) node = times(rotation, node);
    const auto deflection = [&](const MshText& mesh, const Stiffness& stiffness, const Tensor2& axes) {
        Problem problem = box_problem(write_temporary("rotation.msh", mesh.version_2()), stiffness);
        problem.displacements = {{1, {true, true, true}, zero}};
        problem.tractions = {{2, constant(times(axes, {1e6, -2e5, 3e5}))}};
        return solve(problem).at(times(axes, {0.9, 0.4, 0.3})).displacement;
    };
    const Tensor2 identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const Point expected = times(rotation, deflection(straight, triclinic(), identity));
    const Point found = deflection(turned, rotated(triclinic(), rotation), rotation);
    const Point unturned_material = deflection(turned, triclinic(), rotation);
    double difference = 0, twin = 0;
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(found[i], expected[i], 1e-10 * std::abs(expected[0]));
        difference += std::abs(found[i] - expected[i]);
        twin += std::abs(unturned_material[i] - expected[i]);
    }
    EXPECT_GT(twin, 1e6 * difference);
}

Problem loaded_in_every_way() {
    Problem problem = cantilever(write_box("energy.msh", {}), triclinic());
    problem.pressures = {{6, 4e5}};
    problem.displacements.push_back({3, {false, true, false}, [](const Point& x) { return Point{0, 1e-4 * x[0], 0}; }});
    return problem;
}

/// Clapeyron: the work of the loads at their final value is twice the energy, prescribed displacements included.
double clapeyron_defect(const Solution& strained, const Solution& loaded) {
    return std::abs(2 * strained.energy() / loaded.external_work() - 1);
}

TEST(Energy, IsHalfTheWork) {
    for (const int degree : {1, 2}) {
        const Solution solution = solve(loaded_in_every_way(), {.degree = degree});
        EXPECT_GT(solution.energy(), 0);
        EXPECT_LT(clapeyron_defect(solution, solution), 1e-11);
    }
}

TEST(Energy, AMillionthOfOneLoadIsSeen) {
    Problem other = loaded_in_every_way();
    other.pressures[0].value *= 1 + 1e-6;
    EXPECT_GT(clapeyron_defect(solve(loaded_in_every_way()), solve(other)), 1e-9);
}

TEST(IterativeSolver, AgreesWithTheDirectOne) {
    const Problem problem = cantilever(write_box("solvers.msh", {.counts = {6, 6, 6}}), triclinic());
    for (const int degree : {1, 2}) {
        const Solution direct = solve(problem, {.degree = degree, .solver = Solver::direct});
        const Solution iterative = solve(problem, {.degree = degree, .solver = Solver::iterative});
        EXPECT_EQ(direct.record().solver, "cholmod");
        EXPECT_EQ(iterative.record().solver, "cg+two_level");
        EXPECT_LT(direct.record().relative_residual, 1e-12);
        // The residual asked for is 1e-11, the condition of this matrix about 1e3.
        EXPECT_NEAR(iterative.energy() / direct.energy(), 1, 1e-9);
        const Point probe{0.8, 0.3, 0.6};
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(iterative.at(probe).displacement[i], direct.at(probe).displacement[i],
                        1e-8 * std::abs(direct.at(probe).displacement[0]));
    }
}

/// Without its coarse level, Gauss-Seidel alone needs iterations in proportion to 1 / size. 26 are seen, whatever the size.
TEST(IterativeSolver, IterationsDoNotGrowWithTheMesh) {
    const auto iterations = [](int bricks) {
        const Problem problem = cantilever(write_box("growth.msh", {.counts = {bricks, bricks, bricks}}), triclinic());
        return solve(problem, {.solver = Solver::iterative}).record().iterations;
    };
    const int coarse = iterations(3), fine = iterations(9);
    EXPECT_LE(fine, coarse + 10);
    EXPECT_LT(fine, 40);
}

TEST(Solution, QuadratureWeightsSumToTheVolume) {
    Problem problem;
    problem.mesh_file = write_box("weights.msh", {.low = {0, 0, 0}, .high = {2, 3, 4}});
    problem.regions = {{1, triclinic()}};
    problem.displacements = {{1, {true, true, true}, [](const Point&) { return Point{}; }}};
    const Solution solution = solve(problem);
    for (const int order : {1, 2, 3, 4}) {
        double volume = 0;
        for (const FieldSample& sample : solution.quadrature_samples(order)) volume += sample.weight;
        EXPECT_NEAR(volume, 24, 24e-13) << order;
    }
    EXPECT_THROW(solution.quadrature_samples(5), Error);
}

TEST(AutomaticSolver, ChangesAtTheLimit) {
    const Problem problem = cantilever(write_box("limit.msh", {}), triclinic());
    EXPECT_EQ(solve(problem).record().solver, "cholmod");
    EXPECT_EQ(solve(problem, {.direct_limit = 100}).record().solver, "cg+two_level");
}

}  // namespace
}  // namespace cleave::fem::testing
