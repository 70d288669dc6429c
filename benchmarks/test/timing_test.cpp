#include "benchmarks/timing.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace cleave::benchmarks {
namespace {

TEST(Timing, Median) {
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
    EXPECT_THROW(median({}), std::invalid_argument);
}

TEST(Timing, PairsTakeTurnsAndTheFirstPassIsDropped) {
    std::string turns;
    const PairedTimes times = paired_times([&] { turns += 'a'; }, [&] { turns += 'b'; }, 3, [&] { turns += '-'; });
    EXPECT_EQ(turns, "-ab-ab-ab-ab");
    EXPECT_GE(times.first, 0);
    EXPECT_GE(times.ratio, 0);
}

TEST(Timing, WarmPairsRunOnceUntimedRightBefore) {
    std::string turns;
    warm_paired_times({[&] { turns += 'a'; }, [&] { turns += '-'; }}, {[&] { turns += 'b'; }, [&] { turns += '='; }}, 2);
    EXPECT_EQ(turns, "-a-a=b=b-a-a=b=b-a-a=b=b");
}

}  // namespace
}  // namespace cleave::benchmarks
