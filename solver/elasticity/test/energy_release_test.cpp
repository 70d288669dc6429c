// The energy release rate: its two ways, moved by solving anew, Griffith's balance on a strip, and Sneddon's penny.
#include "solver/elasticity/energy_release.hpp"
#include "solver/elasticity/test/equilibrium_bodies.hpp"

#include <gtest/gtest.h>

namespace cleave::elasticity::test {
namespace {

/// Half of a cube is cracked, from x = 0 to x = front; both ends held apart: a short double cantilever beam.
mesh::TetMesh edge_cracked(int n) {
    mesh::TetMesh mesh = particles::test::box_mesh(n, 0.1);
    for (Eigen::Vector3d& x : mesh.vertices)
        for (const int axis : {0, 2})
            if (std::abs(x[axis] - 0.5) < 0.3 / n) x[axis] = 0.5;
    open_crack(mesh, [](const Eigen::Vector3d& x) { return x.z() == 0.5 && x.x() <= 0.5; });
    tag_boundary(mesh);
    return mesh;
}

EquilibriumProblem opened(const mesh::TetMesh& mesh) {
    EquilibriumProblem problem{.mesh = mesh};
    problem.stiffness = {{0, triclinic()}};
    problem.displacements = {{.surface = bottom, .value = [](const auto&) { return Eigen::Vector3d(0, 0, 0); }},
                             {.surface = top, .value = [](const auto&) { return Eigen::Vector3d(2e-5, -3e-5, 1e-4); }}};
    problem.pressures = {{crack, 2e7}};
    problem.body_force = [](const Eigen::Vector3d&) { return Eigen::Vector3d(1e7, 0, -2e7); };
    return problem;
}

/// Growth along x, one at the front, zero at the ends and at the held sides.
CrackExtension forward() {
    return {crack, [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
                const auto hat = [](double t) { return std::max(0.0, 1 - 2.2 * std::abs(t - 0.5)); };
                return {hat(x.x()) * hat(x.z()), 0, 0};
            }};
}

TEST(EnergyRelease, width_is_the_length_of_the_front) { EXPECT_NEAR(crack_width(edge_cracked(4), forward()), 1, 1e-12); }

TEST(EnergyRelease, keeping_the_displacements_equals_solving_anew) {
    const mesh::TetMesh mesh = edge_cracked(4);
    EquilibriumOptions options;
    options.tolerance = 1e-12;
    const EquilibriumProblem problem = opened(mesh);
    const EquilibriumSolution solution = solve_equilibrium(problem, options);
    const EnergyRelease kept = energy_release(problem, options, solution, {forward()}, 1e-4).front();
    const double anew = energy_release_by_solving(problem, options, solution, forward(), 1e-4);
    // Both are central differences, each wrong by O(step^2): 1e-8 times a constant of about the mesh's refinement squared.
    EXPECT_NEAR(kept.by_movement / anew, 1, 1e-5);
    EXPECT_GT(anew, 0);
}

TEST(EnergyRelease, stale_displacements_are_noticed) {
    const mesh::TetMesh mesh = edge_cracked(4);
    const EquilibriumProblem problem = opened(mesh);
    EquilibriumSolution solution = solve_equilibrium(problem);
    const double right = energy_release(problem, {}, solution, {forward()}, 1e-4).front().by_movement;
    for (Eigen::Vector3d& u : solution.displacement) u *= 1.1;
    const double stale = energy_release(problem, {}, solution, {forward()}, 1e-4).front().by_movement;
    EXPECT_GT(std::abs(stale / right - 1), 0.05);
}

TEST(EnergyRelease, places_along_the_front_add_up_to_the_whole) {
    const mesh::TetMesh mesh = edge_cracked(4);
    const EquilibriumProblem problem = opened(mesh);
    const EquilibriumSolution solution = solve_equilibrium(problem);
    std::vector<CrackExtension> extensions{forward()};
    for (int place = 0; place < 3; ++place)
        extensions.push_back({crack, [place](const Eigen::Vector3d& x) -> Eigen::Vector3d {
                                  return forward().growth(x) * std::max(0.0, 1 - 2 * std::abs(x.y() - 0.5 * place));
                              }});
    const std::vector<EnergyRelease> releases = energy_release(problem, {}, solution, extensions, 1e-4);
    double movement = 0, integral = 0, width = 0;
    for (int n = 1; n <= 3; ++n) {
        movement += releases[n].by_movement * releases[n].width;
        integral += releases[n].by_domain_integral * releases[n].width;
        width += releases[n].width;
    }
    EXPECT_NEAR(width, releases[0].width, 1e-12);
    EXPECT_NEAR(movement / (releases[0].by_movement * width), 1, 1e-5) << "linear in the growth, up to step^2";
    EXPECT_NEAR(integral / (releases[0].by_domain_integral * width), 1, 1e-12);
}

/// A strip four long and one high, cracked along half of its middle, nu = 0: held below and `pull` (m) above, `pressure` (Pa) in the crack,
/// `weight` (N/m^3) upwards in its upper half. Far ahead of the front the stress at the middle is E pull + weight / 8; opening it there
/// against the pressure releases G = (E pull + weight / 8 + pressure)^2 / (2 E) per area, in the limit of a long strip.
struct StripLoad {
    const char* name;
    double pull, pressure, weight;
};

class Strip : public testing::TestWithParam<StripLoad> {
public:
    Strip() : mesh_(edge_cracked(8)) {
        for (Eigen::Vector3d& x : mesh_.vertices) x.x() = 0.5 + 4 * (x.x() - 0.5);
        tag_boundary(mesh_, [](const Eigen::Vector3d& x) {
            if (std::abs(x.z()) < 1e-9) return static_cast<int>(bottom);
            if (std::abs(x.z() - 1) < 1e-9) return static_cast<int>(top);
            return std::abs(x.z() - 0.5) < 1e-9 ? static_cast<int>(crack) : static_cast<int>(left);
        });
    }

protected:
    EquilibriumProblem problem(const StripLoad& load) const {
        EquilibriumProblem problem{.mesh = mesh_};
        problem.stiffness = {{0, material::isotropic(young_, 0)}};
        problem.displacements = {{.surface = bottom, .value = [](const auto&) { return Eigen::Vector3d(0, 0, 0); }},
                                 {.surface = top, .value = [load](const auto&) { return Eigen::Vector3d(0, 0, load.pull); }}};
        problem.pressures = {{crack, load.pressure}};
        problem.body_force = [load](const Eigen::Vector3d& x) { return Eigen::Vector3d(0, 0, x.z() > 0.5 ? load.weight : 0); };
        return problem;
    }

    static constexpr double young_ = 7e10;
    mesh::TetMesh mesh_;
};

TEST_P(Strip, releases_the_energy_of_the_stress_it_frees) {
    const StripLoad load = GetParam();
    const EquilibriumSolution solution = solve_equilibrium(problem(load), {.tolerance = 1e-8});
    const CrackExtension extension{crack, [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
                                       return {std::max(0.0, 1 - std::abs(x.x() - 0.5) / 1.2), 0, 0};
                                   }};
    const EnergyRelease release = energy_release(problem(load), {}, solution, {extension}, 1e-3).front();
    const double exact = std::pow(young_ * load.pull + load.weight / 8 + load.pressure, 2) / (2 * young_);
    printf("  strip, %s: by movement %+.2f %%, domain integral %+.2f %%\n", load.name, 100 * (release.by_movement / exact - 1),
           100 * (release.by_domain_integral / exact - 1));
    // Eight particles' layers across the strip: a few per cent.
    EXPECT_NEAR(release.by_movement / exact, 1, 0.05);
    EXPECT_NEAR(release.by_domain_integral / exact, 1, 0.05);
}

INSTANTIATE_TEST_SUITE_P(EnergyRelease, Strip,
                         testing::Values(StripLoad{"pulled", 1e-4, 0, 0}, StripLoad{"blown_up", 0, 7e6, 0}, StripLoad{"heavy", 0, 0, 5e7},
                                         StripLoad{"all_three", 1e-4, 7e6, 5e7}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(EnergyRelease, refuses_growth_that_grows_nothing_and_tets_turned_over) {
    const mesh::TetMesh mesh = edge_cracked(4);
    const EquilibriumProblem problem = opened(mesh);
    const EquilibriumSolution solution = solve_equilibrium(problem);
    const CrackExtension nowhere{crack, [](const auto&) { return Eigen::Vector3d(0, 0, 0); }};
    EXPECT_THROW(energy_release(problem, {}, solution, {nowhere}, 1e-4), std::invalid_argument);
    EXPECT_THROW(energy_release(problem, {}, solution, {forward()}, 5), std::invalid_argument);
}

}  // namespace
}  // namespace cleave::elasticity::test
