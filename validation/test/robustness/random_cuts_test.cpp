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

}  // namespace
}  // namespace cleave::robustness
