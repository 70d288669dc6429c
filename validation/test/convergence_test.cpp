#include "validation/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::validation {
namespace {

/// f = 7 + factor h^order on the sizes, with its exact error.
std::vector<Refinement> power_law(double order, double factor, const std::vector<double>& sizes) {
    std::vector<Refinement> ladder;
    for (const double h : sizes) ladder.push_back({h, 7 + factor * std::pow(h, order), std::abs(factor) * std::pow(h, order)});
    return ladder;
}

TEST(Convergence, AnExactPowerLawIsReadBack) {
    for (const double order : {0.5, 1.0, 2.0, 3.0})
        for (const double factor : {0.4, -0.3}) {
            const auto found = study_convergence(power_law(order, factor, {0.4, 0.2, 0.11}));
            ASSERT_TRUE(found);
            EXPECT_NEAR(*found->order, order, 1e-12);
            EXPECT_NEAR(*found->order_of_values, order, 1e-9) << "three values: the curve through them";
            EXPECT_NEAR(*found->extrapolated, 7, 1e-10);
            EXPECT_NEAR(*found->uncertainty, grid_safety_factor * std::abs(factor) * std::pow(0.11, order), 1e-9) << "1.25 times the true error";
            EXPECT_EQ(found->asymptotic, "stated");
        }
}

TEST(Convergence, FiveSizesByLeastSquares) {
    const auto found = study_convergence(power_law(1.7, 0.9, {0.5, 0.3, 0.2, 0.15, 0.1}));
    EXPECT_NEAR(*found->order_of_values, 1.7, 1e-6) << "golden section stops at the rounding of the residual";
    EXPECT_NEAR(*found->extrapolated, 7, 1e-7);
}

// Roache's own form for a constant ratio: p = ln(e32/e21)/ln r, GCI = 1.25 |e21| / (r^p - 1).
TEST(Convergence, RoachesFormulaAtAConstantRatio) {
    const std::vector<Refinement> ladder{{4, 0.9619, NAN}, {2, 0.9685, NAN}, {1, 0.9705, NAN}};
    const auto found = study_convergence(ladder);
    const double p = std::log(0.0066 / 0.0020) / std::log(2), gci = 1.25 * 0.0020 / (std::pow(2, p) - 1);
    EXPECT_NEAR(*found->order_of_values, p, 1e-9);
    EXPECT_NEAR(*found->extrapolated, 0.9705 + 0.0020 / (std::pow(2, p) - 1), 1e-9);
    EXPECT_NEAR(*found->uncertainty, gci, 1e-9);
    EXPECT_EQ(found->asymptotic, "unknown") << "three values alone cannot check their own order";
}

// Must fail: a wrong exponent is not read out of another one's values; two terms are no power law.
TEST(Convergence, TwinsAreToldApart) {
    EXPECT_GT(std::abs(*study_convergence(power_law(2, 1, {0.4, 0.2, 0.1}))->order_of_values - 1), 0.9);
    std::vector<Refinement> two_terms;
    for (const double h : {0.4, 0.2, 0.1, 0.05}) two_terms.push_back({h, 1 + h - 2.2 * h * h, std::abs(h - 2.2 * h * h)});
    EXPECT_EQ(study_convergence(two_terms)->asymptotic, "denied");
    std::vector<Refinement> floor;
    for (const double h : {0.4, 0.2, 0.1}) floor.push_back({h, std::nullopt, 0.05 + h * h});
    EXPECT_EQ(study_convergence(floor)->asymptotic, "denied") << "an error that stays";
}

TEST(Convergence, RoundingIsNoSlope) {
    const auto exact = study_convergence({{0.4, 1.0, 3e-14}, {0.2, 1.0, 9e-15}, {0.1, 1.0, 4e-14}});
    EXPECT_EQ(exact->asymptotic, "unknown");
}

TEST(Convergence, WhatIsNoLadderHasNoLimit) {
    EXPECT_FALSE(study_convergence({{0.1, 1.0, 0.1}}));
    EXPECT_FALSE(study_convergence({{0.1, 1.0, 0.1}, {0.1, 1.0, 0.1}})) << "no refinement";
    const auto oscillating = study_convergence({{0.4, 1.0, NAN}, {0.2, 1.2, NAN}, {0.1, 1.1, NAN}});
    EXPECT_FALSE(oscillating->extrapolated);
    const auto apart = study_convergence({{0.4, 1.0, NAN}, {0.2, 1.1, NAN}, {0.1, 1.4, NAN}});
    EXPECT_FALSE(apart->extrapolated) << "steps that grow";
    EXPECT_EQ(study_convergence({{0.4, 1.0, 0.2}, {0.2, 1.1, 0.1}})->asymptotic, "unknown") << "two sizes";
}

}  // namespace
}  // namespace cleave::validation
