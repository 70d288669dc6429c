// References of the crack analysis.

#include "validation/analytic/principals.hpp"
#include "validation/analytic/wedged_penny.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cleave::analytic {
namespace {

TEST(Principals, SolveTheEigenproblem) {
    const Gradient tensor{{{3, -1.2, 0.4}, {-1.2, 0.5, 2.1}, {0.4, 2.1, -2}}};
    const Principals found = principals(tensor);
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) {
            double row = 0;
            for (int j = 0; j < 3; ++j) row += tensor[i][j] * found.direction[k][j];
            EXPECT_NEAR(row, found.value[k] * found.direction[k][i], 1e-14 * 5);
        }
    EXPECT_GT(found.value[0], found.value[1]);
    EXPECT_GT(found.value[1], found.value[2]);
    EXPECT_NEAR(angle_between(found.direction[0], found.direction[1]), std::numbers::pi / 2, 1e-14);
}

TEST(Principals, GapAndShear) {
    EXPECT_DOUBLE_EQ(principals(stress_tensor({0, 0, 0, 0, 0, 1})).value[0], 1) << "pure shear";
    EXPECT_DOUBLE_EQ(principals(strain_tensor({0, 0, 0, 0, 0, 1})).value[0], 0.5) << "engineering shear is twice the tensor's";
    EXPECT_DOUBLE_EQ(principals(stress_tensor({2, 0, 0, 0, 0, 0})).gap(), 1);
    EXPECT_DOUBLE_EQ(principals({}).gap(), 0);
}

/// The integral of the intensity over the disc, by the midpoint rule.
TEST(WedgedPenny, IsTheIntegralOverItsDisc) {
    const double young = 200e9, poisson = 0.3, force = 3e6, c = 0.7, a = 1.1, pi = std::numbers::pi;
    double integral = 0;
    constexpr int steps = 100000;
    for (int k = 0; k < steps; ++k) {
        const double r = c * (k + 0.5) / steps;
        integral += r / std::sqrt(a * a - r * r) * c / steps;
    }
    const double intensity = 2 / std::sqrt(pi * a) * force / (pi * c * c) * integral;
    const double expected = intensity * intensity * (1 - poisson * poisson) / young;
    EXPECT_NEAR(wedged_penny_release(young, poisson, force, c, a) / expected, 1, 1e-8);
    const double point = force / std::pow(pi * a, 1.5);
    EXPECT_NEAR(wedged_penny_release(young, poisson, force, 1e-4, a) * young / (1 - poisson * poisson), point * point, 1e-6 * point * point);
}

}  // namespace
}  // namespace cleave::analytic
