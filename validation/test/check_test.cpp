#include "validation/check.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::validation {
namespace {

Measurement measured(double relative, double absolute, std::optional<double> order = {}) { return {1.0, 1.0, relative, absolute, order}; }

Band relative(double limit) { return {limit, {}, {}}; }
Band absolute(double limit) { return {{}, limit, {}}; }
Band order(double limit) { return {{}, {}, limit}; }

// Every kind of band: one measurement inside, its must-fail twin outside.
TEST(Judge, RelativeBand) {
    EXPECT_EQ(judge(measured(0.009, 1), relative(0.01), false), Verdict::pass);
    EXPECT_EQ(judge(measured(0.011, 0), relative(0.01), false), Verdict::fail);
}

TEST(Judge, AbsoluteBand) {
    EXPECT_EQ(judge(measured(1, 0.009), absolute(0.01), false), Verdict::pass);
    EXPECT_EQ(judge(measured(0, 0.011), absolute(0.01), false), Verdict::fail);
}

TEST(Judge, OrderBand) {
    EXPECT_EQ(judge(measured(1, 1, 1.95), order(1.9), false), Verdict::pass);
    EXPECT_EQ(judge(measured(0, 0, 1.85), order(1.9), false), Verdict::fail);
    EXPECT_EQ(judge(measured(0, 0), order(1.9), false), Verdict::fail) << "no order was observed";
}

/// One end of a bracket: the reference itself is on both sides, and no value at all on neither.
TEST(Judge, OneSidedBand) {
    const auto judged = [](double value, BandSide side, bool must_fail = false) {
        Measurement m;
        m.value = value, m.reference = 2;
        return judge(m, {{}, {}, {}, side}, must_fail);
    };
    EXPECT_EQ(judged(1.9, BandSide::below), Verdict::pass);
    EXPECT_EQ(judged(2.1, BandSide::below), Verdict::fail);
    EXPECT_EQ(judged(2.1, BandSide::above), Verdict::pass);
    EXPECT_EQ(judged(1.9, BandSide::above), Verdict::fail);
    EXPECT_EQ(judged(2, BandSide::below), Verdict::pass);
    EXPECT_EQ(judged(2, BandSide::above), Verdict::pass);
    EXPECT_EQ(judged(1.9, BandSide::above, true), Verdict::pass);
    EXPECT_EQ(judged(2.1, BandSide::above, true), Verdict::fail);
    for (const bool must_fail : {false, true}) {
        EXPECT_EQ(judged(std::nan(""), BandSide::below, must_fail), Verdict::fail);
        EXPECT_EQ(judge({}, {{}, {}, {}, BandSide::below}, must_fail), Verdict::fail) << "nothing measured";
    }
}

TEST(Judge, EveryLimitOfABandMustHold) {
    const Band both{0.01, {}, 1.9};
    EXPECT_EQ(judge(measured(0.005, 1, 2.0), both, false), Verdict::pass);
    EXPECT_EQ(judge(measured(0.005, 1, 1.0), both, false), Verdict::fail);
    EXPECT_EQ(judge(measured(0.02, 1, 2.0), both, false), Verdict::fail);
}

TEST(Judge, ATwinPassesOnlyWhereTheBandIsMissedByAFiniteError) {
    EXPECT_EQ(judge(measured(0.02, 1), relative(0.01), true), Verdict::pass);
    EXPECT_EQ(judge(measured(0.005, 1), relative(0.01), true), Verdict::fail);
    EXPECT_EQ(judge(measured(std::nan(""), 1), relative(0.01), true), Verdict::fail);
}

TEST(Judge, NaNNeverPassesAndNoBandIsInfo) {
    EXPECT_EQ(judge(measured(std::nan(""), 0), relative(0.01), false), Verdict::fail);
    EXPECT_EQ(judge(measured(0, std::nan("")), absolute(0.01), false), Verdict::fail);
    EXPECT_EQ(judge(measured(0, 0, std::nan("")), order(1), false), Verdict::fail);
    EXPECT_EQ(judge(measured(0, 0), Band{}, false), Verdict::info);
}

}  // namespace
}  // namespace cleave::validation
