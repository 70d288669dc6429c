#include "validation/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::validation {
namespace {

Row row(const std::string& solver, Side side, double value, std::optional<Side> against, const std::string& source, double reference) {
    Row one;
    one.quantity = "energy_release_rate";
    one.unit = "J/m^2";
    one.place = "whole body";
    one.solver = solver;
    one.side = side;
    one.measurement = {value, reference, std::abs(value / reference - 1), std::abs(value - reference), {}};
    one.reference_side = against;
    one.reference_source = source;
    if (!against) one.measurement.reference.reset();
    return one;
}

std::vector<Row> penny() {
    return {row("sph.conforming", Side::particles, 12, Side::mathematics, "Sneddon", 10),
            row("fem.p2", Side::fem, 9, Side::mathematics, "Sneddon", 10),
            row("fem.p1", Side::fem, 8, Side::mathematics, "Sneddon", 10)};
}

TEST(Comparison, OneLineOfThreeSides) {
    const auto lines = compare_sides(penny());
    ASSERT_EQ(lines.size(), 2U) << "the particles beside quadratic elements; linear ones alone";
    const Comparison& line = lines[0];
    EXPECT_EQ(line.particles->by, "sph.conforming");
    EXPECT_EQ(*line.fem->value, 9);
    EXPECT_EQ(line.mathematics->by, "Sneddon");
    EXPECT_NEAR(line.particles_mathematics->error, 0.2, 1e-12);
    EXPECT_EQ(line.particles_mathematics->row, 0U);
    EXPECT_EQ(line.fem_mathematics->row, 1U);
    EXPECT_NEAR(line.particles_fem->error, 3.0 / 9, 1e-12);
    EXPECT_FALSE(line.particles_fem->row) << "measured, judged by nothing";
    EXPECT_EQ(lines[1].fem->by, "fem.p1");
    EXPECT_FALSE(lines[1].particles);
}

TEST(Comparison, TwinsStayOut) {
    auto rows = penny();
    rows[0].must_fail = true;
    for (const Comparison& line : compare_sides(rows)) EXPECT_FALSE(line.particles);
}

// The norm of a difference is not the difference of the norms: 2 % apart in size, 40 % apart in direction.
TEST(Comparison, NormsAreNotSubtracted) {
    auto rows = penny();
    for (Row& one : rows) one.norm = "rms";
    EXPECT_FALSE(compare_sides(rows)[0].particles_fem);
    rows[0].also.push_back({Side::fem, "fem.p2", 9.0, 0.4, true});
    const auto line = compare_sides(rows)[0];
    ASSERT_TRUE(line.particles_fem);
    EXPECT_EQ(line.particles_fem->error, 0.4);
    EXPECT_FALSE(line.particles_fem->row);
}

TEST(Comparison, AJudgedPairGoesBeforeAMeasuredOne) {
    auto rows = penny();
    rows.push_back(row("sph.conforming", Side::particles, 12, Side::fem, "fem.p2", 9));
    rows[0].also.push_back({Side::fem, "fem.p2", 9.0, 0.4, true});
    EXPECT_EQ(compare_sides(rows)[0].particles_fem->row, 3U);
}

// A case may judge a coarse mesh and a fine one by checks of their own: a pair of numbers from two meshes says nothing.
TEST(Comparison, TheFinestMeshSpeaks) {
    auto rows = penny();
    for (Row& one : rows) one.resolution.size = 0.2;
    for (const std::size_t i : {0, 1}) {
        rows.push_back(rows[i]);
        rows.back().resolution.size = 0.05;
        rows.back().measurement.value = 10.5;
    }
    const auto line = compare_sides(rows)[0];
    EXPECT_EQ(*line.particles->value, 10.5);
    EXPECT_EQ(*line.fem->value, 10.5);
    EXPECT_EQ(line.particles_mathematics->row, 3U);
    rows[4].band.side = BandSide::below;
    rows.push_back(rows[4]);
    rows[4].band = {};
    EXPECT_EQ(compare_sides(rows)[0].fem_mathematics->row, 5U) << "of one mesh the judged one";
}

TEST(Comparison, AnglesAndZerosAreAbsolute) {
    auto rows = penny();
    for (Row& one : rows) one.unit = "deg";
    EXPECT_FALSE(compare_sides(rows)[0].particles_fem->relative);
    EXPECT_NEAR(compare_sides(rows)[0].particles_fem->error, 3, 1e-12);
}

TEST(Comparison, EveryRowInEarnestHasALine) {
    auto rows = penny();
    rows.push_back(row("sph.paper", Side::particles, 3, {}, "", 1));
    std::vector<int> seen(rows.size());
    for (const Comparison& line : compare_sides(rows))
        for (const std::size_t i : line.rows) ++seen[i];
    for (const int times : seen) EXPECT_GE(times, 1);
}

}  // namespace
}  // namespace cleave::validation
