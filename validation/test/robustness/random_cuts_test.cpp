// Any tet, any plane: children fill their parent to 1e-14 L^3, none is negative. Built twice: a hundred thousand cuts in every run, ten
// million under the label robustness.

#include "validation/test/robustness/random_cuts.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace cleave::robustness {
namespace {

TEST(RandomCuts, FillTheirParents) {
    const CutTally tally = cut_at_random(CLEAVE_RANDOM_CUTS, 2026);
    EXPECT_GE(tally.cuts, CLEAVE_RANDOM_CUTS);
    EXPECT_GE(tally.children, 14 * tally.cuts);
    EXPECT_LE(tally.children, 20 * tally.cuts);
    EXPECT_EQ(tally.negative, 0);
    EXPECT_LE(tally.worst_sum, 1e-14);
    EXPECT_LE(tally.worst_stated, 1e-14);
    EXPECT_GT(tally.smallest_share, 0);  // 3e-4 where edges are alike; slivers have a shortest edge that says little of their height
    std::printf("counts: %ld tets cut, %ld children, %ld not positive; sums differ by %.1e L^3 at most, a child by %.1e L^3, the smallest is "
                "%.1e of its parent\n",
                tally.cuts, tally.children, tally.negative, tally.worst_sum, tally.worst_stated, tally.smallest_share);
}

// Must-fail twins, in a cube of edge 2 m: one child's volume off by 1e-12 m^3 (1e-14 L^3 is at most 4.2e-13, no edge being longer than 2 sqrt(3) m),
// one child turned inside out, one point moved by 1e-10 m.
TEST(RandomCuts, SeeOneWrongVolume) {
    const CutTally tally = cut_at_random(500, 7, [](auto& volumes, auto&) { volumes.front() += 1e-12; });
    EXPECT_GT(tally.worst_sum, 1e-14);
    EXPECT_GT(tally.worst_stated, 1e-14);
    EXPECT_EQ(tally.negative, 0);
}

TEST(RandomCuts, SeeOneChildInsideOut) {
    const CutTally tally = cut_at_random(500, 7, [](auto& volumes, auto&) { volumes.back() *= -1; });
    EXPECT_GE(tally.negative, 1);
}

TEST(RandomCuts, SeeOnePointOutOfPlace) {
    const CutTally tally = cut_at_random(500, 7, [](auto&, auto& points) { points.front()[0] += 1e-10; });
    EXPECT_GT(tally.worst_stated, 1e-14);
}

}  // namespace
}  // namespace cleave::robustness
