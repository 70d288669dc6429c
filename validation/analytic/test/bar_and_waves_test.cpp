#include "validation/analytic/barnett_lothe.hpp"
#include "validation/analytic/plane_waves.hpp"
#include "validation/analytic/stretched_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::analytic {
namespace {

/// Axes 1, 2, 3 of three equal normal constants.
Stiffness cubic(double c11, double c12, double c44) {
    Stiffness c{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) c[i][j] = i == j ? c11 : c12;
        c[i + 3][i + 3] = c44;
    }
    return c;
}

const Stiffness silicon = cubic(165.7, 63.9, 79.6);  // GPa

const double half = std::sqrt(0.5);

// Silicon (Hopcroft, Nix and Kenny 2010): 130 and 169 GPa along <100> and <110>.
TEST(StretchedBar, SiliconAlongItsAxesAndDiagonals) {
    EXPECT_NEAR(bar_modulus(silicon, {1, 0, 0}), 130, 0.2);
    EXPECT_NEAR(bar_modulus(silicon, {half, half, 0}), 169, 0.5);
}

// Material M, 45 degrees off its fibre: 1/Ex = c^4/E1 + (1/G12 - 2 nu12/E1) s^2 c^2 + s^4/E2.
TEST(StretchedBar, CompositeOffItsFibre) {
    Stiffness s{};
    const double E1 = 181, E2 = 10.3;
    s[0][0] = 1 / E1, s[1][1] = s[2][2] = 1 / E2;
    s[0][1] = s[1][0] = s[0][2] = s[2][0] = -0.28 / E1, s[1][2] = s[2][1] = -0.47 / E2;
    s[3][3] = 2 * 1.47 / E2, s[4][4] = s[5][5] = 1 / 7.17;
    const double modulus = bar_modulus(invert(s), {half, half, 0});
    EXPECT_NEAR(modulus, 16.74, 0.005);
    EXPECT_NEAR(modulus, 1 / (0.25 / E1 + 0.25 * (1 / 7.17 - 2 * 0.28 / E1) + 0.25 / E2), 1e-12);
}

// Not the stiffness along the bar, which a confined one would have.
TEST(StretchedBar, IsNotConfined) { EXPECT_GT(silicon[0][0], 1.2 * bar_modulus(silicon, {1, 0, 0})); }

TEST(StretchedBar, RefusesAnUnstableBody) { EXPECT_THROW(bar_modulus(cubic(1, 2, 1), {1, 0, 0}), std::invalid_argument); }

// Along [110] of a cubic crystal: density v^2 = C44, (C11 - C12)/2, (C11 + C12 + 2 C44)/2 (Auld 1973, Sect. 7).
TEST(PlaneWaves, CubicDiagonal) {
    const double density = 2329;
    const Stiffness c = cubic(165.7e9, 63.9e9, 79.6e9);
    std::array<double, 3> speeds{std::sqrt((165.7e9 - 63.9e9) / 2 / density), std::sqrt(79.6e9 / density), std::sqrt((165.7e9 + 63.9e9 + 2 * 79.6e9) / 2 / density)};
    EXPECT_LT(wave_speed_error(c, density, {half, half, 0}, speeds), 1e-14);
    // The must-fail twins: another direction, one speed off by a millionth, no number.
    EXPECT_GT(wave_speed_error(c, density, {1, 0, 0}, speeds), 1e-3);
    speeds[1] *= 1 + 1e-6;
    EXPECT_NEAR(wave_speed_error(c, density, {half, half, 0}, speeds), 2e-6, 1e-8);
    speeds[1] = std::nan("");
    EXPECT_TRUE(std::isnan(wave_speed_error(c, density, {half, half, 0}, speeds)));
}

// det(Gamma - x I) = 0 with the functions for its coefficients, where the eigenvalues are known.
TEST(PlaneWaves, FunctionsAreThoseOfTheEigenvalues) {
    const SymmetricFunctions found = christoffel_functions(silicon, {0, 0, 1}), exact = symmetric_functions({165.7, 79.6, 79.6});
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i] / exact[i], 1, 1e-14);
}

TEST(CrackAxes, AboutAnAxisAreRightHanded) {
    const double third = std::sqrt(1.0 / 3);
    const CrackAxes axes = axes_about({third, -third, third});
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(product(axes[i], axes[j]), i == j, 1e-15);
    const double determinant = axes[0][0] * (axes[1][1] * axes[2][2] - axes[1][2] * axes[2][1]) -
                               axes[0][1] * (axes[1][0] * axes[2][2] - axes[1][2] * axes[2][0]) +
                               axes[0][2] * (axes[1][0] * axes[2][1] - axes[1][1] * axes[2][0]);
    EXPECT_NEAR(determinant, 1, 1e-15);
    EXPECT_EQ(axes[2], (Point{third, -third, third}));
}

}  // namespace
}  // namespace cleave::analytic
