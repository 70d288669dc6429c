#include "reference_fem/crack_direction.hpp"
#include "reference_fem/crack_integrals.hpp"
#include "reference_fem/elasticity.hpp"
#include "reference_fem/kinked_crack.hpp"
#include "reference_fem/test/materials.hpp"
#include "reference_fem/test/msh_text.hpp"
#include "reference_fem/vector3.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace cleave::fem {
namespace {

using testing::triclinic;

Stiffness isotropic(double young, double nu) {
    const double lambda = young * nu / ((1 + nu) * (1 - 2 * nu)), mu = young / (2 * (1 + nu));
    Stiffness c{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) c[i][j] = lambda + (i == j ? 2 * mu : 0);
        c[i + 3][i + 3] = mu;
    }
    return c;
}

/// sigma = C grad u of a mode at a place, as a full tensor.
testing::Tensor2 stress_of(const Stiffness& c, const NearTip::State& state, int mode) {
    testing::Tensor2 gradient{};
    for (int i = 0; i < 3; ++i)
        for (int d = 0; d < 2; ++d) gradient[i][d] = state.slope[mode][d][i];
    return testing::stress_tensor(c, gradient);
}

class NearTips : public ::testing::TestWithParam<std::pair<Stiffness, TipForm>> {};

TEST_P(NearTips, AreBalancedFreeOnTheLipsAndOfUnitIntensity) {
    const auto& [c, form] = GetParam();
    const auto tip = near_tip(c, form);
    const double step = 1e-5;
    for (int mode = 0; mode < 3; ++mode) {
        const auto ahead = stress_of(c, tip->at(1, 0), mode), upper = stress_of(c, tip->at(-1, 1e-300), mode), lower = stress_of(c, tip->at(-1, -1e-300), mode);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(ahead[i][1] * std::sqrt(2 * std::numbers::pi), i == (mode == 0 ? 0 : mode == 1 ? 1 : 2) ? 1 : 0, 1e-5);
            EXPECT_NEAR(upper[i][1], 0, 1e-5);
            EXPECT_NEAR(lower[i][1], 0, 1e-5);
        }
        for (const auto& [x, y] : {std::pair{0.3, 0.8}, std::pair{-0.7, -0.4}}) {
            Point force{};
            for (int d = 0; d < 2; ++d) {
                const double dx = d == 0 ? step : 0, dy = d == 1 ? step : 0;
                const NearTip::State plus = tip->at(x + dx, y + dy), minus = tip->at(x - dx, y - dy), here = tip->at(x, y);
                const auto s = stress_of(c, plus, mode), t = stress_of(c, minus, mode);
                const double size = norm(here.slope[mode][0]) + norm(here.slope[mode][1]);
                for (int i = 0; i < 3; ++i) {
                    force[i] += (s[i][d] - t[i][d]) / (2 * step);
                    EXPECT_NEAR((plus.displacement[mode][i] - minus.displacement[mode][i]) / (2 * step), here.slope[mode][d][i], 1e-6 * size);
                }
            }
            EXPECT_LT(norm(force), 1e-5) << "mode " << mode;  // stresses of order one; the difference's own error is 1e-9
        }
    }
}

// Crack-closure work (Irwin 1957): G = lim 1/(2 d) int_0^d t(x) . jump(d - x) dx = k L^-1 k / 2; both fields scale as square roots,
// int_0^1 sqrt((1-x)/x) dx = pi/2.
TEST_P(NearTips, ComplianceIsThatOfClosure) {
    const auto& [c, form] = GetParam();
    const auto tip = near_tip(c, form);
    const NearTip::State upper = tip->at(-1, 1e-300), lower = tip->at(-1, -1e-300);
    const Tensor compliance = tip->compliance();
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
            const double jump = upper.displacement[b][a] - lower.displacement[b][a];
            const double closure = 0.5 * std::numbers::pi / 2 * jump / std::sqrt(2 * std::numbers::pi);
            EXPECT_NEAR(closure / compliance[1][1], compliance[a][b] / 2 / compliance[1][1], 1e-5);
        }
}

INSTANTIATE_TEST_SUITE_P(Materials, NearTips,
                         ::testing::Values(std::pair{isotropic(200e9, 0.3), TipForm::isotropic}, std::pair{isotropic(200e9, 0.3), TipForm::stroh},
                                           std::pair{triclinic(), TipForm::stroh}));

TEST(NearTip, IsotropicFormRefusesAnisotropy) { EXPECT_THROW(near_tip(triclinic(), TipForm::isotropic), Error); }

TEST(KinkAngle, PureShearIsErdoganAndSihs) {
    const double degree = std::numbers::pi / 180;
    EXPECT_NEAR(kink_angle(isotropic(1, 0.3), {1, 0, 0}, [](double) { return 1.0; }) / degree, -70.529, 1e-2);
    EXPECT_NEAR(kink_angle(isotropic(1, 0.3), {0, 1, 0}, [](double) { return 1.0; }) / degree, 0, 1e-4);
}

TEST(KinkAngle, RefusesAnisotropyForTheEnergy) { EXPECT_THROW(energy_kink_angle(triclinic(), {1, 1, 0}), Error); }

// A kink straight on is no kink; a small one: K'_I = K_I - 3/2 angle K_II, K'_II = K_II + angle/2 K_I (Cotterell and Rice 1980, Int. J. Fract.
// 16, 155), next terms of order angle^2 = 1e-4.
TEST(KinkedCrack, SmallAnglesAreCotterellAndRices) {
    const double angle = 0.01;
    const KinkFactors straight = kink_factors(0), small = kink_factors(angle), other = kink_factors(-angle);
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            EXPECT_NEAR(straight[i][j], i == j ? 1 : 0, 1e-5);
            EXPECT_NEAR(small[i][j], i == j ? 1 : (i == 0 ? -1.5 : 0.5) * angle, 6e-4);
            EXPECT_NEAR(other[i][j], (i == j ? 1 : -1) * small[i][j], 1e-6) << "mirrored";
        }
}

// Published (Amestoy and Leblond 1992): pure shear 75.76 deg, and no shear in the kink at 77.33 deg. The hoop angle, 70.53 deg, is a twin.
TEST(KinkedCrack, PureShearIsAmestoyAndLeblonds) {
    const double degree = std::numbers::pi / 180;
    EXPECT_NEAR(energy_kink_angle(isotropic(1, 0.3), {1, 0, 0}) / degree, -75.76, 0.01);
    EXPECT_NEAR(energy_kink_angle(isotropic(1, 0.3), {-1, 0, 0}) / degree, 75.76, 0.01);
    EXPECT_NEAR(kink_factors(-77.33 * degree)[1][1], 0, 2e-4);
    EXPECT_GT(std::abs(kink_factors(-70.53 * degree)[1][1]), 0.05);
}

TEST(PrincipalStress, IsThatOfATurnedUniaxialState) {
    const double c = std::cos(0.4), s = std::sin(0.4);  // tension 5 along (c, s, 0), 2 across, 1 along z
    const PrincipalStress found = largest_principal_stress({5 * c * c + 2 * s * s, 5 * s * s + 2 * c * c, 1, 0, 0, 3 * c * s});
    EXPECT_NEAR(found.value, 5, 1e-12);
    EXPECT_NEAR(found.gap, 3 / std::sqrt(30.0), 1e-12);
    EXPECT_NEAR(std::abs(found.direction[0] * c + found.direction[1] * s), 1, 1e-12);
    EXPECT_EQ(largest_principal_stress({}).gap, 0);
}

/// A box of bricks with a crack in z = 0, its lips the surface 7: `in_crack(x, margin)` holds for the nodes inside it (margin < 0), or those and
/// its front (margin > 0). Vertices moved by step times the growth, then all lengths times `unit`.
std::string cracked_box(const std::string& name, const testing::Box& box, const std::function<bool(const Point&, double margin)>& in_crack,
                        const VectorField& growth = {}, double step = 0, double unit = 1) {
    testing::MshText mesh = testing::box_mesh(box);
    const auto place = [&](int node) { return mesh.nodes[static_cast<std::size_t>(node)]; };
    const auto on_crack = [&](int node, double margin) { return std::abs(place(node)[2]) < 1e-9 && in_crack(place(node), margin); };
    std::map<int, int> copy;
    for (int node = 0, last = static_cast<int>(mesh.nodes.size()); node < last; ++node)
        if (on_crack(node, -1e-9)) {
            copy[node] = static_cast<int>(mesh.nodes.size());
            mesh.nodes.push_back(place(node));
        }
    std::vector<testing::MshText::Triangle> sides = mesh.triangles;
    for (testing::MshText::Tet& tet : mesh.tets) {
        double height = 0;
        for (const int node : tet.nodes) height += place(node)[2];
        std::vector<int> lip;
        bool split = false;  // a corner of the square whose three vertices are all on the front stays whole
        for (int& node : tet.nodes)
            if (on_crack(node, 1e-9)) {
                split = split || copy.contains(node);
                if (height > 0 && copy.contains(node)) node = copy[node];
                lip.push_back(node);
            }
        if (lip.size() == 3 && split) mesh.triangles.push_back({{lip[0], lip[1], lip[2]}, 7});
    }
    for (std::size_t i = 0; i < sides.size(); ++i) {  // above the crack they belong to the copies
        double height = 0;
        for (const int node : sides[i].nodes) height += place(node)[2];
        for (int& node : mesh.triangles[i].nodes)
            if (height > 0 && copy.contains(node)) node = copy[node];
    }
    if (growth)
        for (Point& x : mesh.nodes) x = x + step * growth(x);
    for (Point& x : mesh.nodes) x = unit * x;
    return testing::write_temporary(name, mesh.version_2());
}

/// A cube of 4^3 bricks, |x|, |y|, |z| <= 1, with a crack, the square |x|, |y| <= 1/2 at z = 0 less two corners.
std::string cracked_cube(const std::string& name, const VectorField& growth, double step, double unit = 1) {
    const auto square = [](const Point& x, double margin) { return std::abs(x[0]) < 0.5 + margin && std::abs(x[1]) < 0.5 + margin; };
    return cracked_box(name, {.low = {-1, -1, -1}, .high = {1, 1, 1}, .counts = {4, 4, 4}, .distortion = 0}, square, growth, step, unit);
}

/// Tangential to the lips, zero on the sides.
Point growth_of_cube(const Point& x) {
    const double share = (1 - x[0] * x[0]) * (1 - x[1] * x[1]) * (1 - x[2] * x[2]);
    return {share * (0.5 + x[0]), share * (x[1] - 0.2), 0};
}

/// Triclinic, pulled and sheared, under pressure on the lips and a body force that varies; lengths times `unit`, stresses as they were.
Problem loaded_cube(const std::string& mesh, double unit = 1) {
    Problem problem;
    problem.mesh_file = mesh;
    problem.regions = {{1, triclinic()}};
    problem.pressures = {{7, 40e6}};
    problem.body_force = [unit](const Point& x) { return 1 / (unit * unit) * Point{1e9 * x[1], 6e8 * unit, 2e9 * x[0] - 5e8 * x[2]}; };
    problem.displacements = {{5, {true, true, true}, [](const Point&) { return Point{0, 0, 0}; }},
                             {6, {true, true, true}, [unit](const Point& x) { return Point{1e-3 * unit, 2e-4 * x[0], 3e-3 * unit}; }}};
    return problem;
}

// The domain integral is the derivative of the discrete potential energy: 1e-5 is the difference's own error, step^2 = 1e-6 of size one.
TEST(CrackIntegrals, DomainIntegralIsTheDerivativeByMovedVertices) {
    const double step = 1e-3;
    const Problem problem = loaded_cube(cracked_cube("crack_cube.msh", growth_of_cube, 0));
    const Solution solution = solve(problem);
    const CrackGrowth crack{problem, solution, growth_of_cube, 7};
    const auto potential = [&](double by) {
        const Problem moved = loaded_cube(cracked_cube("crack_cube_moved.msh", growth_of_cube, by));
        return potential_energy(moved, solve(moved));
    };
    const double by_movement = (potential(-step) - potential(step)) / (2 * step * crack_width(crack));
    EXPECT_NEAR(energy_release_by_domain(crack) / by_movement, 1, 1e-5);

    // Twins: each load matters, so that a form without its term would fail.
    Problem without_pressure = problem, without_force = problem;
    without_pressure.pressures.clear();
    without_force.body_force = {};
    EXPECT_GT(std::abs(energy_release_by_domain({without_pressure, solution, growth_of_cube, 7}) / by_movement - 1), 1e-3);
    EXPECT_GT(std::abs(energy_release_by_domain({without_force, solution, growth_of_cube, 7}) / by_movement - 1), 1e-3);
}

// A crack of a nanometre releases a 10^-9th of the energy per area. The body force varies in space: its share takes a difference over a
// length, which must be the body's.
TEST(CrackIntegrals, TheUnitOfLengthDoesNotMatter) {
    const auto release = [](double unit) {
        const Problem problem = loaded_cube(cracked_cube("crack_cube_of_unit.msh", {}, 0, unit), unit);
        const Solution solution = solve(problem);
        return energy_release_by_domain({problem, solution, [unit](const Point& x) { return growth_of_cube(1 / unit * x); }, 7}) / unit;
    };
    const double one = release(1);
    for (const double unit : {1e-9, 1e-6, 1e3}) EXPECT_NEAR(release(unit) / one, 1, 1e-9) << unit;
}

TEST(CrackIntegrals, GrowthThatAddsNoAreaIsAnError) {
    const Problem problem = loaded_cube(cracked_cube("crack_cube.msh", growth_of_cube, 0));
    const Solution solution = solve(problem);
    EXPECT_THROW(crack_width({problem, solution, [](const Point& x) { return -1 * growth_of_cube(x); }, 7}), Error);
}

/// A front along -y through the origin, the lips at x < 0 in the plane z = 0.
CrackFront line() {
    const auto locate = [](const Point& x) { return FrontPlace{{Point{1, 0, 0}, Point{0, 0, 1}, Point{0, -1, 0}}, x[0], x[2], -x[1]}; };
    return {locate, [](double t) { return Point{0, -t, 0}; }, 0.5, 0};
}

/// Ahead, one near the front, zero from 0.9 on.
Point growth_of_line(const Point& x) { return {std::clamp(1.6 - std::hypot(x[0], x[2]) / 0.55, 0.0, 1.0), 0, 0}; }

// Exact near-tip fields of all modes in a triclinic material, and a quadratic field that loads the lips and needs a body force: no
// discretisation, what is left is quadrature. On the ends y = +-1/4 everything cancels. 1e-5: the rule of degree 5 on cells of h = 1/12 at
// r > 0.33 errs by (h/r)^6, 3e-4, a cell, with alternating sign over hundreds.
TEST(CrackIntegrals, InteractionIntegralReturnsTheIntensitiesOfExactFields) {
    const auto half = [](const Point& x, double margin) { return x[0] < margin; };
    Problem problem;
    problem.mesh_file = cracked_box("crack_line.msh", {.low = {-1, -0.25, -1}, .high = {1, 0.25, 1}, .counts = {24, 1, 24}, .distortion = 0}, half);
    problem.regions = {{1, triclinic()}};
    problem.displacements = {{1, {true, true, true}, [](const Point&) { return Point{0, 0, 0}; }}};
    const Solution solution = solve(problem, {.degree = 1});

    const Elasticity& material = solution.material(0);
    const AuxiliaryField field(material, line());
    const Intensities k{2e6, 3e6, -1e6};
    const double size = 4e-5;  // strain at distance 1
    const auto smooth = [&](const Point& x) {
        return Tensor{{{2 * size * x[0], 0, size * x[2]}, {size * (x[2] - x[0] - 1), 0, size * x[0]}, {size * x[2], 0, size * (x[0] + 3 * x[2] + 1)}}};
    };
    problem.tractions = {{.surface = 7, .stress = [&](const Point& x) { return material.stress(smooth(x)); }}};
    problem.body_force = [&](const Point&) {  // the gradient is linear: its divergence by a difference of any length
        Point force{};
        for (int j = 0; j < 3; ++j) {
            Point up{}, down{};
            up[j] = 0.5, down[j] = -0.5;
            const Voigt plus = material.stress(smooth(up)), minus = material.stress(smooth(down));
            for (int i = 0; i < 3; ++i) force[i] -= plus[voigt_index(i, j)] - minus[voigt_index(i, j)];
        }
        return force;
    };
    const auto exact = [&](const Point& x) {
        Tensor gradient = smooth(x);
        const AuxiliaryField::State state = field.at(x, false);
        for (int mode = 0; mode < 3; ++mode)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) gradient[i][j] += k[mode] * state.gradient[mode][i][j];
        return gradient;
    };
    const auto error = [&](const Problem& of) {
        const FrontIntensities found = intensities_by_interaction({of, solution, growth_of_line, 7, exact}, field, {0, 0, 0});
        double most = 0;
        for (int mode = 0; mode < 3; ++mode) most = std::max(most, std::abs(found.k[mode] - k[mode]) / 3e6);
        return most;
    };
    EXPECT_LT(error(problem), 1e-5);

    // Twins: each load matters.
    Problem without_traction = problem, without_force = problem;
    without_traction.tractions.clear();
    without_force.body_force = {};
    EXPECT_GT(error(without_traction), 1e-3);
    EXPECT_GT(error(without_force), 1e-3);
}

/// A circular front of radius 1 about z in the plane z = 0.
CrackFront circle() {
    const auto locate = [](const Point& x) {
        const double r = std::hypot(x[0], x[1]), c = x[0] / r, s = x[1] / r, t = std::atan2(x[1], x[0]);
        return FrontPlace{{Point{c, s, 0}, Point{0, 0, 1}, Point{s, -c, 0}}, r - 1, x[2], t < 0 ? t + 2 * std::numbers::pi : t};
    };
    return {locate, [](double t) { return Point{std::cos(t), std::sin(t), 0}; }, 2 * std::numbers::pi, 2 * std::numbers::pi};
}

// On a curved front: the stress is that of the displacement's gradient, its divergence is of order r^-1/2 where single terms are r^-3/2.
TEST(AuxiliaryField, IsCompatibleAndItsDivergenceIsOfLowerOrder) {
    const Elasticity material({1, triclinic()});
    const AuxiliaryField field(material, circle());
    for (const double r : {0.1, 0.01}) {
        const Point x{1.0 + 0.6 * r, 0.3, 0.8 * r};
        const AuxiliaryField::State state = field.at(x, true);
        const double step = 1e-3 * r;
        for (int mode = 0; mode < 3; ++mode) {
            double size = 0;
            for (const double s : state.stress[mode]) size = std::max(size, std::abs(s));
            EXPECT_LT(norm(state.divergence[mode]), 4 * size) << "radius 1: the curvature's share";
            for (int j = 0; j < 3; ++j) {
                Point up = x, down = x;
                up[j] += step, down[j] -= step;
                const auto plus = field.displacement(up), minus = field.displacement(down);
                for (int i = 0; i < 3; ++i)
                    EXPECT_NEAR((plus[mode][i] - minus[mode][i]) / (2 * step), state.gradient[mode][i][j], 1e-5 * size / 30e9);
            }
        }
    }
}

}  // namespace
}  // namespace cleave::fem
