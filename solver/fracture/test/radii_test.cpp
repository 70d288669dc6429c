#include "solver/fracture/radii.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cleave::fracture {
namespace {

TEST(ProportionalRadius, GoesWithTheEnergyAndIsCapped) {
    EXPECT_DOUBLE_EQ(proportional_radius(6, 4, 0.5, 1, 100), 3);
    EXPECT_DOUBLE_EQ(proportional_radius(12, 4, 0.5, 1, 100), 6);
    EXPECT_DOUBLE_EQ(proportional_radius(12, 4, 0.5, 1, 5), 5);
    EXPECT_DOUBLE_EQ(proportional_radius(6, 4, 0.5, contact_weight(8, 2, 1), 100), 0.75) << "eta = 1: a larger contact, a smaller crack";
    EXPECT_DOUBLE_EQ(contact_weight(8, 2, 0), 1);
    EXPECT_DOUBLE_EQ(contact_weight(8, 2, -0.5), 0.5);
}

/// The balance G(a) = G_c, from the intensity itself.
TEST(WedgedRadius, IsWhereTheIntensityMeetsTheToughness) {
    const double force = 300, modulus = 7e10, toughness = 8, a = wedged_radius(force, toughness, modulus, 1);
    const double intensity = force / std::pow(std::numbers::pi * a, 1.5);
    EXPECT_NEAR(intensity * intensity / modulus, toughness, 1e-12 * toughness);
    EXPECT_NEAR(wedged_radius(8 * force, toughness, modulus, 1), 4 * a, 1e-12) << "a goes with F^(2/3)";
    EXPECT_EQ(wedged_radius(1e9, toughness, modulus, 1), 1);
}

/// Density of the spread energy where the paper lost a cube: poly6 of Mueller et al. (2003).
double density(double energy, double h, double r) {
    return 315 / (64 * std::numbers::pi * std::pow(h, 9)) * std::pow(h * h - r * r, 3) * energy;
}

TEST(InnerRadius, IsWhereTheDensityMeetsTheLimit) {
    const double h = 0.02, energy = 0.003, limit = 200;
    const double r = inner_radius(energy, h, limit, 1);
    EXPECT_GT(r, 0);
    EXPECT_NEAR(density(energy, h, r), limit, 1e-9 * limit);
}

TEST(InnerRadius, GrowsWithTheEnergyFromZero) {
    const double h = 0.02, limit = 200, least = 64 * std::numbers::pi * h * h * h * limit / 315;
    EXPECT_EQ(inner_radius(0.999 * least, h, limit, 1), 0);
    double last = 0;
    for (int k = 0; k < 23; ++k) {  // to 1e4 of the least
        const double energy = 1.001 * least * std::pow(1.5, k);
        const double r = inner_radius(energy, h, limit, 1);
        EXPECT_GT(r, last);
        EXPECT_LT(r, h);
        last = r;
    }
    EXPECT_EQ(inner_radius(1e4 * least, h, limit, 0.001), 0.001) << "never beyond r_outer";
    EXPECT_EQ(inner_radius(1e4 * least, h, 0, 1), 0) << "no limit, no inner radius";
}

/// Twin: with h = r_outer, as the sentence of the paper could be read, the inner radius shrinks while U grows.
TEST(InnerRadius, OfTheOuterRadiusWouldShrink) {
    const double least = 0.05;
    bool shrinks = false;
    double last = 0;
    for (int k = 0; k < 18; ++k) {  // to 100 of the least
        const double energy = least * std::pow(1.3, k);
        const double outer = proportional_radius(energy, 8, 0.1, 1, 1e9), r = inner_radius(energy, outer, 20, outer);
        shrinks |= r < last;
        last = r;
    }
    EXPECT_TRUE(shrinks);
}

TEST(EquilibriumRadius, StableRestsUnstableRunsThrough) {
    const auto wedge = [](double a) { return 1 / (a * a * a); };
    const EquilibriumRadius rests = equilibrium_radius(wedge, 8, 0.1, 10);
    EXPECT_EQ(rests.rest, Rest::stable);
    EXPECT_NEAR(rests.radius, 0.5, 1e-6);
    const auto tension = [](double a) { return a; };
    EXPECT_EQ(equilibrium_radius(tension, 2, 0.1, 10).rest, Rest::never_starts);
    EXPECT_EQ(equilibrium_radius(tension, 2, 2.5, 10).rest, Rest::runs_through);
    EXPECT_EQ(equilibrium_radius(tension, 2, 2.5, 10).radius, 10);
}

}  // namespace
}  // namespace cleave::fracture
