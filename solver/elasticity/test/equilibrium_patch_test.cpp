// Fields the method must reproduce exactly: linear displacement in one material, piecewise linear in a laminate.
#include "solver/elasticity/test/equilibrium_bodies.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace cleave::elasticity::test {
namespace {

// Rounding of about 200 CG iterations at tolerance 1e-12, condition about 1e4.
constexpr double exact = 1e-9;

EquilibriumOptions tight() {
    EquilibriumOptions options;
    options.tolerance = 1e-13;
    return options;
}

EquilibriumProblem pulled_cube(const mesh::TetMesh& mesh, const LinearField& field, const std::vector<int>& held) {
    const material::Stiffness stiffness = triclinic();
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{0, stiffness}};
    const Eigen::Matrix3d stress = stress_matrix(stiffness, field.gradient);
    for (int side = left; side <= top; ++side) {
        if (std::find(held.begin(), held.end(), side) != held.end()) problem.displacements.push_back({.surface = side, .value = field});
        else problem.tractions.push_back({side, [stress](const auto&, const Eigen::Vector3d& n) -> Eigen::Vector3d { return stress * n; }});
    }
    return problem;
}

TEST(Patch, linear_field_under_prescribed_displacement) {
    const mesh::TetMesh mesh = tagged_cube(4);
    const EquilibriumSolution solution = solve_equilibrium(pulled_cube(mesh, {}, {left, right, front, back, bottom, top}), tight());
    EXPECT_LT(worst_displacement(solution, LinearField{}), exact);
    EXPECT_LT(solution.report.residual, 1e-11);
}

TEST(Patch, linear_field_under_tractions_and_one_held_side) {
    const mesh::TetMesh mesh = tagged_cube(4);
    const EquilibriumSolution solution = solve_equilibrium(pulled_cube(mesh, {}, {bottom}), tight());
    EXPECT_LT(worst_displacement(solution, LinearField{}), exact);
    const Eigen::Matrix3d stress = stress_matrix(triclinic(), LinearField{}.gradient);
    for (const material::Voigt& value : solution.fields.stress)
        EXPECT_LT((material::stress_from_voigt(value) - stress).norm(), exact * stress.norm());
    EXPECT_LT(solution.link_energy, 1e-18 * solution.strain_energy);
}

TEST(Patch, single_components_held_on_three_sides) {
    const mesh::TetMesh mesh = tagged_cube(4);
    const material::Stiffness stiffness = triclinic();
    // No shear at the faces of the held components, so that they are free of shear traction: a strain from a diagonal stress.
    const Eigen::Matrix3d stress = Eigen::Vector3d(3e7, -2e7, 1e7).asDiagonal();
    const material::Voigt strain = material::compliance(stiffness) * material::stress_to_voigt(stress);
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    gradient.diagonal() = strain.head<3>();
    gradient(0, 1) = strain[5], gradient(0, 2) = strain[4], gradient(1, 2) = strain[3];
    const auto field = [gradient](const Eigen::Vector3d& x) -> Eigen::Vector3d { return gradient * x; };
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{0, stiffness}};
    problem.displacements = {
        {left, {true, false, false}, field}, {front, {false, true, false}, field}, {bottom, {false, false, true}, field}};
    for (const int side : {right, back, top})
        problem.tractions.push_back({side, [stress](const auto&, const Eigen::Vector3d& n) -> Eigen::Vector3d { return stress * n; }});
    EXPECT_LT(worst_displacement(solve_equilibrium(problem, tight()), field), exact);
}

TEST(Patch, pressure_is_the_traction_against_the_normal) {
    const mesh::TetMesh mesh = tagged_cube(4);
    const material::Stiffness stiffness = triclinic();
    const double pressure = 2e7;
    const material::Voigt strain = material::compliance(stiffness) * material::stress_to_voigt(-pressure * Eigen::Matrix3d::Identity());
    const Eigen::Matrix3d gradient = material::strain_from_voigt(strain);
    const auto field = [gradient](const Eigen::Vector3d& x) -> Eigen::Vector3d { return gradient * x; };
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{0, stiffness}};
    problem.displacements = {{.surface = bottom, .value = field}};
    for (const int side : {left, right, front, back, top}) problem.pressures.push_back({side, pressure});
    EXPECT_LT(worst_displacement(solve_equilibrium(problem, tight()), field), exact);
}

TEST(Patch, the_exact_field_is_in_balance_without_a_solve) {
    const mesh::TetMesh mesh = tagged_cube(4);
    const EquilibriumProblem problem = pulled_cube(mesh, {}, {bottom});
    std::vector<Eigen::Vector3d> exact_field, bent;
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) {
        const Eigen::Vector3d x = mesh::tet_centroid(mesh, static_cast<int>(tet));
        exact_field.push_back(LinearField{}(x));
        bent.push_back(exact_field.back() + 1e-4 * x.x() * x.x() * Eigen::Vector3d::UnitY());
    }
    // The sum of a few hundred rounded products per particle; interior faces cancel exactly.
    EXPECT_LT(balance_residual(problem, exact_field), 1e-11);
    EXPECT_GT(balance_residual(problem, bent), 1e-4);
    EquilibriumOptions shepard;
    shepard.traces.order = 0;
    EXPECT_GT(balance_residual(problem, exact_field, shepard), 1e-3);
}

TEST(Patch, fails_with_shepard_traces) {
    const mesh::TetMesh mesh = tagged_cube(4);
    EquilibriumOptions options = tight();
    options.traces.order = 0;
    EXPECT_GT(worst_displacement(solve_equilibrium(pulled_cube(mesh, {}, {bottom}), options), LinearField{}), 0.01);
}

/// Two triclinic layers, interface z = 1/2: gradient A below, A + a (x) e_z above, with the jump a that keeps the traction.
struct Laminate {
    mesh::TetMesh mesh;
    std::map<int, material::Stiffness> stiffness{{1, triclinic(5)}, {2, triclinic(8)}};
    Eigen::Matrix3d below = LinearField{}.gradient, above;

    explicit Laminate(int n) : mesh(particles::test::box_mesh(n, 0.15)) {
        for (Eigen::Vector3d& x : mesh.vertices)
            if (std::abs(x.z() - 0.5) < 0.3 / n) x.z() = 0.5;
        for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet)
            mesh.regions[tet] = mesh::tet_centroid(mesh, static_cast<int>(tet)).z() < 0.5 ? 1 : 2;
        tag_boundary(mesh);
        const Eigen::Vector3d n_z = Eigen::Vector3d::UnitZ();
        Eigen::Matrix3d acoustic;
        for (int k = 0; k < 3; ++k)
            acoustic.col(k) = stress_matrix(stiffness.at(2), Eigen::Vector3d::Unit(k) * n_z.transpose()) * n_z;
        const Eigen::Vector3d jump = (stress_matrix(stiffness.at(1), below) - stress_matrix(stiffness.at(2), below)) * n_z;
        above = below + acoustic.inverse() * jump * n_z.transpose();
    }

    Eigen::Vector3d displacement(const Eigen::Vector3d& x) const {
        return below * x + (above - below) * Eigen::Vector3d(0, 0, std::max(0.0, x.z() - 0.5));
    }

    /// Tractions on two sides, the rest held.
    EquilibriumProblem problem() const {
        EquilibriumProblem problem{.mesh = mesh, .stiffness = stiffness};
        for (const int side : {left, front, bottom, top})
            problem.displacements.push_back({.surface = side, .value = [this](const auto& x) { return displacement(x); }});
        for (const int side : {right, back})
            problem.tractions.push_back({side, [this](const Eigen::Vector3d& x, const Eigen::Vector3d& n) -> Eigen::Vector3d {
                                             return stress_matrix(stiffness.at(x.z() < 0.5 ? 1 : 2), x.z() < 0.5 ? below : above) * n;
                                         }});
        return problem;
    }

    double worst_strain(const EquilibriumSolution& solution, const Fields& fields) const {
        double worst = 0;
        for (int i = 0; i < solution.body->particles.size(); ++i) {
            const Eigen::Matrix3d& gradient = solution.body->particles.position[i].z() < 0.5 ? below : above;
            worst = std::max(worst, (fields.strain[i] - strain_of(gradient)).norm() / strain_of(gradient).norm());
        }
        return worst;
    }
};

TEST(Laminate, two_triclinic_layers_are_exact) {
    const Laminate laminate(4);
    ASSERT_GT((laminate.above - laminate.below).norm(), 0.1 * laminate.below.norm());
    const EquilibriumSolution solution = solve_equilibrium(laminate.problem(), tight());
    EXPECT_LT(laminate.worst_strain(solution, solution.fields), 1e-9);
    EXPECT_LT(laminate.worst_strain(solution, solution.recovered), 1e-9);
    EXPECT_LT(solution.link_energy, 1e-18 * solution.strain_energy);
}

TEST(Laminate, one_stencil_across_the_interface_misses_it) {
    const Laminate laminate(4);
    EquilibriumOptions options = tight();
    options.traces.split_interfaces = false;
    const EquilibriumSolution solution = solve_equilibrium(laminate.problem(), options);
    EXPECT_GT(laminate.worst_strain(solution, solution.fields), 0.05);
}

TEST(Laminate, regions_of_one_stiffness_are_one_material) {
    Laminate laminate(4);
    laminate.stiffness[2] = laminate.stiffness[1];
    const ConformingBody split = make_conforming_body(laminate.mesh, laminate.stiffness);
    for (int& region : laminate.mesh.regions) region = 1;
    const ConformingBody whole = make_conforming_body(laminate.mesh, laminate.stiffness);
    EXPECT_EQ(split.traces.weight, whole.traces.weight);
}

}  // namespace
}  // namespace cleave::elasticity::test
