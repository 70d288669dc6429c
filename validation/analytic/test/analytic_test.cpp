#include "validation/analytic/laminate.hpp"
#include "validation/analytic/lekhnitskii_hole.hpp"
#include "validation/analytic/linear_displacement.hpp"
#include "validation/analytic/manufactured_trigonometric.hpp"
#include "validation/analytic/sneddon_penny.hpp"
#include "validation/analytic/uniform_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::analytic {
namespace {

/// Stiffness from orthotropic engineering constants, by inverting the compliance.
Stiffness orthotropic(double E1, double E2, double E3, double G23, double G13, double G12, double nu12, double nu13, double nu23) {
    Stiffness s{};
    s[0][0] = 1 / E1, s[1][1] = 1 / E2, s[2][2] = 1 / E3;
    s[0][1] = s[1][0] = -nu12 / E1, s[0][2] = s[2][0] = -nu13 / E1, s[1][2] = s[2][1] = -nu23 / E2;
    s[3][3] = 1 / G23, s[4][4] = 1 / G13, s[5][5] = 1 / G12;
    return invert(s);
}

// T300/5208-like material with nu23 = 0.47; constants in GPa (Tsai and Hahn 1980).
Stiffness fibre_composite() { return orthotropic(181, 10.3, 10.3, 10.3 / 2.94, 7.17, 7.17, 0.28, 0.28, 0.47); }

/// A stiffness without symmetry: A A^T + 30 I with fixed entries.
Stiffness triclinic() {
    Stiffness c{};
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            double sum = i == j ? 30.0 : 0.0;
            for (int k = 0; k < 6; ++k) sum += std::sin(1.0 + 3 * i + 7 * k) * std::sin(1.0 + 3 * j + 7 * k) * 12;
            c[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = sum;
        }
    return c;
}

/// -div sigma by central differences of the stress.
Point minus_divergence(const Field& field, const Point& x, double step) {
    constexpr std::size_t voigt[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
    Point result{};
    for (std::size_t j = 0; j < 3; ++j) {
        Point up = x, down = x;
        up[j] += step;
        down[j] -= step;
        const Voigt plus = field.stress(up), minus = field.stress(down);
        for (std::size_t i = 0; i < 3; ++i) result[i] -= (plus[voigt[i][j]] - minus[voigt[i][j]]) / (2 * step);
    }
    return result;
}

double gradient_error(const Field& field, const Point& x, double step) {
    double error = 0, size = 0;
    const Gradient exact = field.gradient(x);
    for (std::size_t b = 0; b < 3; ++b) {
        Point up = x, down = x;
        up[b] += step;
        down[b] -= step;
        const Point plus = field.displacement(up), minus = field.displacement(down);
        for (std::size_t a = 0; a < 3; ++a) {
            error = std::max(error, std::abs((plus[a] - minus[a]) / (2 * step) - exact[a][b]));
            size = std::max(size, std::abs(exact[a][b]));
        }
    }
    return error / size;
}

TEST(Manufactured, IsInBalanceWithItsBodyForce) {
    const Field field = manufactured_trigonometric(triclinic(), 2.0);
    for (const Point& x : {Point{0.1, 0.2, 0.3}, Point{0.9, 1.7, 0.4}, Point{1.5, 0.05, 1.9}}) {
        const Point force = field.body_force(x), divergence = minus_divergence(field, x, 1e-4);
        double size = 0;
        for (const double f : force) size = std::max(size, std::abs(f));
        // second-order differences: (step q / L)^2 / 6 = 1e-8, rounding 1e-12 / 1e-4
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(divergence[i], force[i], 1e-7 * size);
        EXPECT_LT(gradient_error(field, x, 1e-5), 1e-8);
    }
}

TEST(Manufactured, ABalanceWithTheWrongStiffnessIsSeen) {
    Stiffness wrong = triclinic();
    wrong[5][5] *= 2;  // the factor of two between tensor and engineering shear
    const Field right = manufactured_trigonometric(triclinic(), 2.0), false_field = manufactured_trigonometric(wrong, 2.0);
    const Point x{0.9, 1.7, 0.4};
    double difference = 0;
    for (std::size_t i = 0; i < 3; ++i) difference = std::max(difference, std::abs(minus_divergence(right, x, 1e-4)[i] - false_field.body_force(x)[i]));
    EXPECT_GT(difference, 1e-3 * std::abs(right.body_force(x)[0]));
}

TEST(Constitutive, SimpleShearUsesTheShearModulus) {
    Gradient g{};
    g[0][1] = 2e-3;  // u_x = gamma y
    EXPECT_NEAR(stress_of(fibre_composite(), g)[5], 7.17 * 2e-3, 1e-12);
    EXPECT_NEAR(strain_of(g)[5], 2e-3, 1e-18);
}

TEST(Constitutive, InverseTimesStiffnessIsIdentity) {
    const Stiffness c = triclinic(), s = invert(c);
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) {
            double sum = 0;
            for (std::size_t k = 0; k < 6; ++k) sum += c[i][k] * s[k][j];
            EXPECT_NEAR(sum, i == j ? 1 : 0, 1e-13);
        }
    EXPECT_THROW(invert(Stiffness{}), std::invalid_argument);
}

TEST(Hole, PolesOfTheFibreCompositeInPlaneStrainAndPlaneStress) {
    // Closed-form values for this material: 6.6522 / -0.2697 (plane strain), 6.7505 / -0.2385 (plane stress), load along the fibre;
    // 2.5242 / -3.7084 and 2.3718 / -4.1920 across it.
    struct Row { PlaneState state; RemoteStress remote; double at_pole, at_other; };
    const RemoteStress along{1, 0, 0}, across{0, 1, 0};
    for (const Row& row : {Row{PlaneState::strain, along, 6.6522, -0.2697}, Row{PlaneState::stress, along, 6.7505, -0.2385},
                           Row{PlaneState::strain, across, 2.5242, -3.7084}, Row{PlaneState::stress, across, 2.3718, -4.1920}}) {
        const Field field = lekhnitskii_hole(fibre_composite(), 2.0, row.remote, row.state);
        const bool x_load = row.remote.xx > 0;
        const Voigt top = field.stress({0, 2, 0}), side = field.stress({2, 0, 0});
        EXPECT_NEAR(x_load ? top[0] : side[1], row.at_pole, 6e-5);
        EXPECT_NEAR(x_load ? side[1] : top[0], row.at_other, 6e-5);
    }
    EXPECT_NEAR(hole_stress_concentration(fibre_composite(), PlaneState::strain), 6.6522, 5e-5);
    EXPECT_NEAR(hole_stress_concentration(fibre_composite(), PlaneState::stress), 6.7505, 5e-5);
}

TEST(Hole, IsotropicLimitIsKirsch) {
    Stiffness c = orthotropic(1, 1, 1, 1 / 2.6, 1 / 2.6, 1 / 2.6, 0.3, 0.3, 0.3);
    EXPECT_THROW(lekhnitskii_hole(c, 1, {1, 0, 0}, PlaneState::strain), std::invalid_argument);
    c[5][5] *= 1 + 1e-6;
    const Field field = lekhnitskii_hole(c, 1, {1, 0, 0}, PlaneState::strain);
    for (const auto& [r, theta] : {std::pair{1.0, 1.2}, std::pair{1.7, 0.4}, std::pair{3.0, 2.0}}) {
        const Voigt s = field.stress({r * std::cos(theta), r * std::sin(theta), 0});
        // Kirsch 1898: hoop stress (1 + 1/r^2)/2 - (1 + 3/r^4) cos(2 theta)/2
        const double c2 = std::cos(theta), s2 = std::sin(theta);
        const double hoop = s[0] * s2 * s2 + s[1] * c2 * c2 - 2 * s[5] * s2 * c2;
        EXPECT_NEAR(hoop, (1 + 1 / (r * r)) / 2 - (1 + 3 / std::pow(r, 4)) * std::cos(2 * theta) / 2, 1e-5);
    }
}

TEST(Hole, FieldIsInBalanceFreeOnTheHoleAndCompatible) {
    const Field field = lekhnitskii_hole(fibre_composite(), 1.0, {1, 0.3, -0.2}, PlaneState::strain);
    for (const double theta : {0.1, 0.8, 2.0, 3.9, 5.5}) {
        const double c = std::cos(theta), s = std::sin(theta);
        const Voigt rim = field.stress({c, s, 0});
        EXPECT_NEAR(rim[0] * c + rim[5] * s, 0, 1e-12);
        EXPECT_NEAR(rim[5] * c + rim[1] * s, 0, 1e-12);
        const Point x{1.6 * c, 1.6 * s, 0.1};
        for (const double value : minus_divergence(field, x, 1e-4)) EXPECT_NEAR(value, 0, 1e-6);
        // stress from the displacement by C, against stress from the potentials
        const Voigt direct = field.stress(x), from_displacement = stress_of(fibre_composite(), field.gradient(x));
        for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(from_displacement[i], direct[i], 1e-7);
    }
    EXPECT_TRUE(std::isnan(field.stress({0.5, 0, 0})[0]));
}

TEST(Hole, ARotatedFrameTurnsTheField) {
    // Turning material and load by 90 degrees turns the field: material with fibre along y, load along y.
    const Stiffness turned = orthotropic(10.3, 181, 10.3, 7.17, 10.3 / 2.94, 7.17, 0.28 * 10.3 / 181, 0.47, 0.28);
    const Field a = lekhnitskii_hole(fibre_composite(), 1, {1, 0, 0}, PlaneState::strain);
    const Field b = lekhnitskii_hole(turned, 1, {0, 1, 0}, PlaneState::strain);
    EXPECT_NEAR(a.stress({0.4, 1.3, 0})[0], b.stress({1.3, 0.4, 0})[1], 1e-10);
    EXPECT_NEAR(a.stress({0.4, 1.3, 0})[1], b.stress({1.3, 0.4, 0})[0], 1e-10);
}

TEST(Laminate, IsContinuousAndItsTractionToo) {
    const Field field = laminate(triclinic(), fibre_composite(), 0.4, generic_gradient());
    const Point below{0.3, 0.7, 0.4}, above{0.3, 0.7, 0.4 + 1e-12};
    for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(field.displacement(below)[a], field.displacement(above)[a], 1e-14);
    const Voigt under = field.stress(below), over = field.stress(above);
    double jump = 0;
    for (const std::size_t i : {2U, 3U, 4U}) EXPECT_NEAR(under[i], over[i], 1e-14 * 200);  // entries of C up to 200
    for (const std::size_t i : {0U, 1U, 5U}) jump = std::max(jump, std::abs(under[i] - over[i]));
    EXPECT_GT(jump, 1e-3) << "the stress in the plane differs between the layers";
    EXPECT_LT(gradient_error(field, {0.1, 0.2, 0.9}, 1e-5), 1e-9);
}

TEST(Penny, ReproducesTheTextbookNumbersAndItsOwnEnergyBalance) {
    const Stiffness steel = orthotropic(2e11, 2e11, 2e11, 2e11 / 2.6, 2e11 / 2.6, 2e11 / 2.6, 0.3, 0.3, 0.3);
    const Field penny = sneddon_penny(steel, 2, 1e6, 1);
    EXPECT_NEAR(penny.scalars.at("energy_release_rate"), 11.58648, 1e-5);  // = K^2 (1 - nu^2) / E with K = 1.595769e6 Pa m^0.5
    // dU/dA = G: U grows with the crack's area pi a^2
    const double step = 1e-4;
    const double up = sneddon_penny(steel, 2 + step, 1e6, 1).scalars.at("energy"), down = sneddon_penny(steel, 2 - step, 1e6, 1).scalars.at("energy");
    EXPECT_NEAR((up - down) / (2 * step) / (2 * std::numbers::pi * 2), 11.58648, 1e-5);
    // work of the pressure on an elliptical opening: p * opening * (2/3) pi a^2 / 2 = U
    EXPECT_NEAR(1e6 * penny.scalars.at("crack_opening") * std::numbers::pi * 4 * 2 / 3 / 2, penny.scalars.at("energy"), 1e-9);
    EXPECT_THROW(sneddon_penny(fibre_composite(), 2, 1e6, 1), std::invalid_argument);
}

TEST(UniformStress, IsTheStressOfItsDisplacementInTurnedAxes) {
    const Voigt given{3, -2, 1, 0.5, -0.7, 0.4};
    const Field field = uniform_stress(triclinic(), given, {1, 2, 3}, 0.8);
    const Voigt stress = field.stress({}), from_gradient = stress_of(triclinic(), field.gradient({}));
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(stress[i], from_gradient[i], 1e-12);
    // A turn keeps trace and norm, and by a right angle about z it exchanges x and y.
    const auto norm = [](const Voigt& s) { return s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]); };
    EXPECT_NEAR(stress[0] + stress[1] + stress[2], 2, 1e-13);
    EXPECT_NEAR(norm(stress), norm(given), 1e-12);
    const Voigt quarter = uniform_stress(triclinic(), given, {0, 0, 1}, std::numbers::pi / 2).stress({});
    const Voigt expected{-2, 3, 1, -0.7, -0.5, -0.4};  // x' = y, y' = -x: yz' = xz, xz' = -yz, xy' = -xy
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(quarter[i], expected[i], 1e-13);
    const Point u = field.displacement({0, 1, 0});
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(u[i], field.gradient({})[i][1], 1e-15);
    EXPECT_THROW(uniform_stress(triclinic(), given, {0, 0, 0}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace cleave::analytic
