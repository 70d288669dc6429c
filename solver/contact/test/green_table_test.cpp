#include "solver/contact/green_table.hpp"
#include "solver/contact/half_space.hpp"
#include "solver/material/material.hpp"
#include "solver/material/test/test_materials.hpp"

#include <gtest/gtest.h>

#include <random>

namespace cleave::contact {
namespace {

using Eigen::Vector3d;

constexpr double radius = 0.6;

/// Places within 30 radii of the contact, a third of them within a hundredth of their distance of the surface.
std::vector<Vector3d> places(const Vector3d& inward, int count) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> number(0, 1);
    const Eigen::Matrix3d axes = surface_axes(inward);
    std::vector<Vector3d> list;
    for (int k = 0; k < count; ++k) {
        const double distance = radius * std::pow(30, number(generator)), phi = 2 * M_PI * number(generator);
        const double cosine = (k % 3 == 0 ? 0.01 : 1.0) * number(generator), sine = std::sqrt(1 - cosine * cosine);
        list.push_back(distance * (axes * Vector3d(sine * std::cos(phi), sine * std::sin(phi), cosine)));
    }
    return list;
}

/// Largest difference from the sums over directions, relative, where the table is used; and how many places it is used for.
std::pair<double, int> largest_error(const material::Stiffness& c, const Vector3d& inward, double accuracy, double of_radius = radius) {
    const ContactLoad load{.inward = inward, .force = {3, -2, 5}, .radius = of_radius};
    const auto half_space = std::make_shared<HalfSpace>(c, inward, HalfSpaceOptions{.form = HalfSpaceForm::stroh, .accuracy = accuracy, .tabulated = true});
    const HalfSpaceField table(half_space, load), sum = half_space_field(c, load, {.form = HalfSpaceForm::stroh, .accuracy = 1e-10});
    double worst = 0;
    int used = 0;
    for (const Vector3d& x : places(inward, 200)) {
        if (!half_space->green_table()->covers(surface_axes(inward).transpose() * x, of_radius)) continue;
        ++used;
        const Vector3d exact = sum.displacement(x);
        worst = std::max(worst, (table.displacement(x) - exact).norm() / exact.norm());
    }
    return {worst, used};
}

material::Stiffness stiffness(const std::string& name) { return material::find_material(name).stiffness; }

TEST(GreenTable, KeepsTheAccuracyAskedFor) {
    struct Asked {
        std::string material;
        Vector3d inward;
        double accuracy;
    };
    for (const Asked& asked : {Asked{"silicon", {0.6, 0, 0.8}, 1e-3}, Asked{"silicon", {0.6, 0, 0.8}, 1e-5}, Asked{"T300/5208", {0, 0, 1}, 1e-3},
                               Asked{"Sitka spruce", {0.5, 0.5, 0.7}, 1e-3}}) {
        const auto [error, used] = largest_error(stiffness(asked.material), asked.inward, asked.accuracy);
        EXPECT_LT(error, asked.accuracy) << asked.material;
        EXPECT_GT(used, 60) << asked.material << ": of 200 places, evenly spread over the logarithm of their distance, 1 to 30 radii";
    }
}

/// Fibres on end: rows near the surface need 10,000s of directions, which the sum extrapolates instead.
TEST(GreenTable, BelowStandingFibres) {
    const auto [error, used] = largest_error(stiffness("T300/5208"), {1, 0, 0}, 1e-3);
    EXPECT_LT(error, 1e-3);
    EXPECT_GT(used, 40);
}

TEST(GreenTable, PointForceEverywhere) {
    const auto [error, used] = largest_error(stiffness("silicon"), {1, 1, 0}, 1e-4, 0);
    EXPECT_LT(error, 1e-4);
    EXPECT_EQ(used, 200);
}

/// Bicubic: an accuracy a hundred times finer takes about 3.2 times the cells.
TEST(GreenTable, ConvergesLikeTheFourthPower) {
    const auto table = std::make_shared<StrohTable>(stiffness("silicon"), 2048);
    const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    const GreenTable coarse(table, axes, 1e-3), fine(table, axes, 1e-5);
    const double order = std::log(coarse.probed_error() / fine.probed_error()) / std::log(double(fine.cells()) / coarse.cells());
    EXPECT_GT(order, 3.5);
    EXPECT_LT(order, 5);
}

/// Under the patch the sum stands in, to the bit; the table itself, asked for a place it does not cover, is off.
TEST(GreenTable, LeavesThePatchToTheSum) {
    const ContactLoad load{.force = {3, -2, 5}, .radius = radius};
    const HalfSpaceOptions options{.form = HalfSpaceForm::stroh, .accuracy = 1e-3};
    HalfSpaceOptions tabulated = options;
    tabulated.tabulated = true;
    const HalfSpaceField with = half_space_field(stiffness("silicon"), load, tabulated), without = half_space_field(stiffness("silicon"), load, options);
    const Vector3d below(0.2, 0.1, 0.5);
    EXPECT_EQ(with.displacement(below), without.displacement(below));
    const Vector3d uncovered = with.half_space().green_table()->displacement(below, load.force, radius);
    EXPECT_GT((uncovered - without.displacement(below)).norm(), 1e-2 * uncovered.norm()) << "must fail twin";
}

/// A table of one direction of the surface is no table of another.
TEST(GreenTable, KnowsItsSurface) {
    const Vector3d x(3, 1, 2);
    const HalfSpaceField other = half_space_field(material::rotate_stiffness(stiffness("silicon"), surface_axes({0.6, 0, 0.8}).transpose()),
                                                  {.force = {3, -2, 5}, .radius = radius}, {.form = HalfSpaceForm::stroh, .accuracy = 1e-3, .tabulated = true});
    const HalfSpaceField exact = half_space_field(stiffness("silicon"), {.force = {3, -2, 5}, .radius = radius});
    EXPECT_GT((other.displacement(x) - exact.displacement(x)).norm(), 1e-2 * exact.displacement(x).norm()) << "must fail twin";
}

TEST(GreenTable, SaysWhereItCannot) {
    const auto table = std::make_shared<StrohTable>(stiffness("silicon"), 256);
    EXPECT_THROW(GreenTable(table, Eigen::Matrix3d::Identity(), 1e-13), std::runtime_error);
}

}  // namespace
}  // namespace cleave::contact
