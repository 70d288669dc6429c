// Solves: conservation, repeatability, the direct solver beside the iteration, orders of convergence, errors.
#include "solver/elasticity/equilibrium_system.hpp"
#include "solver/elasticity/test/equilibrium_bodies.hpp"
#include "solver/elasticity/test/test_fields.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace cleave::elasticity::test {
namespace {

/// A cracked cube, held below, pulled above, pressure in the crack, its own weight.
EquilibriumProblem loaded(const mesh::TetMesh& mesh) {
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{0, triclinic()}};
    problem.displacements = {{.surface = bottom, .value = [](const Eigen::Vector3d& x) -> Eigen::Vector3d { return 1e-4 * x; }}};
    problem.tractions = {{top, [](const Eigen::Vector3d& x, const auto&) { return Eigen::Vector3d(1e6, 2e6 * x.x(), 5e6); }}};
    problem.pressures = {{crack, 3e6}};
    problem.body_force = [](const Eigen::Vector3d&) { return Eigen::Vector3d(0, 0, -2.5e4); };
    return problem;
}

TEST(Equilibrium, iteration_and_cholesky_agree) {
    const mesh::TetMesh mesh = cracked_cube(4, 0.3);
    EquilibriumOptions iterative, direct;
    iterative.tolerance = 1e-12;
    direct.solver = EquilibriumSolver::cholesky;
    const EquilibriumSolution a = solve_equilibrium(loaded(mesh), iterative), b = solve_equilibrium(loaded(mesh), direct);
    Vectors difference = a.displacement;
    for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= b.displacement[i];
    EXPECT_LT(dot(difference, difference), 1e-18 * dot(a.displacement, a.displacement));
    EXPECT_NEAR(a.potential / b.potential, 1, 1e-12);
    EXPECT_LT(b.report.residual, 1e-11);
}

TEST(Equilibrium, the_same_bits_for_one_and_two_threads) {
    const mesh::TetMesh mesh = cracked_cube(6, 0.3);
    const auto solve = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        return solve_equilibrium(loaded(mesh)).displacement;
    };
    EXPECT_EQ(solve(1), solve(2));
}

TEST(Equilibrium, energy_is_half_the_work_where_nothing_moves_by_prescription) {
    const mesh::TetMesh mesh = cracked_cube(4, 0.3);
    EquilibriumProblem problem = loaded(mesh);
    problem.displacements[0].value = [](const auto&) { return Eigen::Vector3d(0, 0, 0); };
    const EquilibriumSolution solution = solve_equilibrium(problem);
    EXPECT_NEAR(solution.potential / (-0.5 * solution.external_work), 1, 1e-9);
    EXPECT_GT(solution.external_work, 0);
}

TEST(Equilibrium, potential_is_least_at_the_solution) {
    const mesh::TetMesh mesh = cracked_cube(4, 0.3);
    const EquilibriumProblem problem = loaded(mesh);
    const EquilibriumSolution solution = solve_equilibrium(problem);
    const EquilibriumSystem system = make_system(problem, default_link_penalty, solution.body);
    const Vectors random = random_vectors(solution.body->particles.size(), 5);
    const auto potential = [&](double by) {
        Vectors u = solution.displacement;
        for (std::size_t i = 0; i < u.size(); ++i) u[i] += by * 1e-7 * random[i];
        return system.potential(u);
    };
    EXPECT_GT(potential(1), potential(0));
    // Stationary: the odd part vanishes beside the even one.
    EXPECT_NEAR((potential(1) - potential(-1)) / (potential(1) - potential(0)), 0, 1e-5);
}

TEST(Equilibrium, vertices_moved_by_a_billionth_change_nothing) {
    const mesh::TetMesh mesh = cracked_cube(6, 0.3);
    mesh::TetMesh shaken = mesh;
    const Vectors random = random_vectors(static_cast<int>(mesh.vertices.size()), 11);
    // Both lips of a crack move together: equal places, equal moves.
    std::map<std::array<double, 3>, Eigen::Vector3d> moves;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Eigen::Vector3d& x = mesh.vertices[v];
        shaken.vertices[v] += 1e-9 * moves.emplace(std::array{x[0], x[1], x[2]}, random[v]).first->second;
    }
    const double before = solve_equilibrium(loaded(mesh)).potential, after = solve_equilibrium(loaded(shaken)).potential;
    EXPECT_NEAR(after / before, 1, 1e-6);
    EXPECT_NE(after, before);
}

/// One side of a free block pushed off its centre.
EquilibriumProblem pushed(const mesh::TetMesh& mesh) {
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{0, triclinic()}};
    problem.density = {{0, 2500}};
    problem.free_body = true;
    problem.tractions = {{left, [](const Eigen::Vector3d& x, const auto&) { return Eigen::Vector3d(1e6 * x.y(), 2e5, -3e5 * x.z()); }}};
    return problem;
}

TEST(FreeBody, load_and_acceleration_balance) {
    mesh::TetMesh mesh = tagged_cube(5);
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) mesh.regions[tet] = mesh::tet_centroid(mesh, static_cast<int>(tet)).y() > 0.4;
    EquilibriumProblem problem = pushed(mesh);
    problem.stiffness[1] = triclinic(8);
    problem.density[1] = 7800;
    const EquilibriumSolution solution = solve_equilibrium(problem, {.tolerance = 1e-11});
    EXPECT_LT(solution.report.residual, 1e-9);
    Eigen::Vector3d load = Eigen::Vector3d::Zero(), torque = load, inertia = load, turn = load;
    double scale = 0;
    for (const BoundaryTrace& face : solution.boundary) {
        if (face.surface != left) continue;
        const Eigen::Vector3d f = face.area * problem.tractions[0].value(face.position, face.normal);
        load += f, torque += face.position.cross(f), scale += f.norm();
    }
    const particles::Particles& particles = solution.body->particles;
    for (int i = 0; i < particles.size(); ++i) {
        const Eigen::Vector3d f = problem.density.at(particles.region[i]) * particles.volume[i] * solution.acceleration[i];
        inertia += f, turn += particles.position[i].cross(f);
    }
    EXPECT_LT((load - inertia).norm(), 1e-9 * scale);
    EXPECT_LT((torque - turn).norm(), 1e-9 * scale);
}

TEST(FreeBody, displacement_has_no_rigid_part) {
    const mesh::TetMesh mesh = tagged_cube(4);
    const EquilibriumSolution solution = solve_equilibrium(pushed(mesh));
    Eigen::Vector3d mean = Eigen::Vector3d::Zero(), turn = mean;
    double size = 0;
    const particles::Particles& particles = solution.body->particles;
    for (int i = 0; i < particles.size(); ++i) {
        mean += particles.volume[i] * solution.displacement[i];
        turn += particles.volume[i] * particles.position[i].cross(solution.displacement[i]);
        size += particles.volume[i] * solution.displacement[i].norm();
    }
    EXPECT_LT(mean.norm(), 1e-12 * size);
    EXPECT_LT(turn.norm(), 1e-12 * size);
}

TEST(FreeBody, a_bar_accelerated_by_one_end_has_the_stress_of_its_own_inertia) {
    // Isotropic with nu = 0 and a uniform end load p: sigma_xx = -p (1 - x), the others zero, quadratic displacement.
    const mesh::TetMesh mesh = tagged_cube(8, 0.15);
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{0, material::isotropic(7e10, 0)}};
    problem.free_body = true;
    problem.pressures = {{left, 1e6}};
    const EquilibriumSolution solution = solve_equilibrium(problem);
    double error = 0, scale = 0;
    for (int i = 0; i < solution.body->particles.size(); ++i) {
        const double exact = -1e6 * (1 - solution.body->particles.position[i].x());
        error += std::pow(solution.recovered.stress[i][0] - exact, 2) + solution.recovered.stress[i].tail<5>().squaredNorm();
        scale += exact * exact;
    }
    EXPECT_LT(std::sqrt(error / scale), 0.05) << "first order: a cube of eight cells";
}

// Fewer particles than the preconditioner's lumps hold: the whole body is one lump, which has no stiffness.
TEST(FreeBody, so_coarse_that_it_is_one_lump) {
    const mesh::TetMesh mesh = tagged_cube(2, 0);
    const Eigen::Matrix3d stress = Eigen::Vector3d(1e6, -2e6, 5e5).asDiagonal();
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{0, triclinic()}};
    problem.free_body = true;
    for (const int side : {left, right, front, back, bottom, top})
        problem.tractions.push_back({side, [=](const auto&, const Eigen::Vector3d& normal) -> Eigen::Vector3d { return stress * normal; }});
    const EquilibriumSolution solution = solve_equilibrium(problem, {.tolerance = 1e-12});
    for (const material::Voigt& found : solution.fields.stress) EXPECT_LT((material::stress_from_voigt(found) - stress).norm(), 1e-8 * stress.norm());
}

/// Errors (rms over rms) of a triclinic cube under the smooth field's displacement on three sides, its tractions and body force.
struct Errors {
    double displacement = 0, stress = 0, recovered = 0;
};

Errors manufactured(int n) {
    const mesh::TetMesh mesh = tagged_cube(n);
    const Field field = smooth_field();
    const material::Stiffness stiffness = triclinic();
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{0, stiffness}};
    for (const int side : {left, front, bottom}) problem.displacements.push_back({.surface = side, .value = field.value});
    for (const int side : {right, back, top})
        problem.tractions.push_back({side, [=](const Eigen::Vector3d& x, const Eigen::Vector3d& normal) -> Eigen::Vector3d {
                                         return stress_matrix(stiffness, field.gradient(x)) * normal;
                                     }});
    problem.body_force = [=](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        // -div sigma by central differences of the exact stress: 1e-9 relative, far below the errors measured.
        Eigen::Vector3d force = Eigen::Vector3d::Zero();
        for (int j = 0; j < 3; ++j) {
            const Eigen::Vector3d step = 1e-5 * Eigen::Vector3d::Unit(j);
            const Eigen::Matrix3d change = field.gradient(x + step) - field.gradient(x - step);
            force -= stress_matrix(stiffness, change).col(j) / 2e-5;
        }
        return force;
    };
    const EquilibriumSolution solution = solve_equilibrium(problem, {.tolerance = 1e-8});
    const particles::Particles& particles = solution.body->particles;
    Errors error, scale;
    for (int i = 0; i < particles.size(); ++i) {
        const Eigen::Vector3d& x = particles.position[i];
        const material::Voigt stress = stiffness * strain_of(field.gradient(x));
        const double v = particles.volume[i];
        error.displacement += v * (solution.displacement[i] - field.value(x)).squaredNorm();
        scale.displacement += v * field.value(x).squaredNorm();
        error.stress += v * (solution.fields.stress[i] - stress).squaredNorm();
        error.recovered += v * (solution.recovered.stress[i] - stress).squaredNorm();
        scale.stress += v * stress.squaredNorm();
    }
    return {std::sqrt(error.displacement / scale.displacement), std::sqrt(error.stress / scale.stress),
            std::sqrt(error.recovered / scale.stress)};
}

TEST(Equilibrium, manufactured_solution_converges) {
    std::vector<double> size, displacement, stress, recovered;
    for (const int n : {5, 7, 10}) {
        const Errors errors = manufactured(n);
        size.push_back(1.0 / n), displacement.push_back(errors.displacement);
        stress.push_back(errors.stress), recovered.push_back(errors.recovered);
        printf("  %5d particles: displacement %.2f %%, stress %.2f %%, recovered stress %.2f %%\n", 6 * n * n * n,
               100 * errors.displacement, 100 * errors.stress, 100 * errors.recovered);
    }
    printf("  orders: displacement %.2f, stress %.2f, recovered stress %.2f\n", order(size, displacement), order(size, stress),
           order(size, recovered));
    EXPECT_GT(order(size, displacement), 1.7);
    EXPECT_GT(order(size, stress), 0.95);
    EXPECT_GT(order(size, recovered), 1.2);
    EXPECT_LT(recovered.back(), stress.back());
}

void expect_refused(const EquilibriumProblem& problem, const std::string& part) {
    try {
        solve_equilibrium(problem);
        FAIL() << part;
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(Errors, say_what_was_expected) {
    const mesh::TetMesh mesh = tagged_cube(2);
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{0, triclinic()}};
    problem.pressures = {{top, 1e6}};
    expect_refused(problem, "free body");
    const auto zero = [](const auto&) { return Eigen::Vector3d(0, 0, 0); };
    problem.displacements = {{left, {true, true, false}, zero}};
    expect_refused(problem, "rigid motion");
    problem.displacements = {{left, {true, true, true}, zero}, {left, {false, true, false}, zero}};
    expect_refused(problem, "component y twice");
    problem.displacements = {{left, {true, true, true}, zero}};
    problem.pressures = {{42, 1e6}};
    expect_refused(problem, "42");
    problem.pressures.clear();
    problem.free_body = true;
    expect_refused(problem, "not both");
}

TEST(Errors, a_piece_that_a_crack_cuts_off_is_found) {
    mesh::TetMesh mesh = particles::test::box_mesh(2, 0);
    open_crack(mesh, [](const Eigen::Vector3d& x) { return std::abs(x.z() - 0.5) < 1e-9; });
    tag_boundary(mesh);
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{0, triclinic()}};
    problem.displacements = {{.surface = bottom, .value = [](const auto&) { return Eigen::Vector3d(0, 0, 0); }}};
    expect_refused(problem, "piece 2 of 2");
}

TEST(Errors, too_few_iterations_are_reported) {
    const mesh::TetMesh mesh = cracked_cube(4, 0.3);
    EXPECT_THROW(solve_equilibrium(loaded(mesh), {.max_iterations = 5}), std::runtime_error);
}

}  // namespace
}  // namespace cleave::elasticity::test
