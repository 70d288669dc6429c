#include "solver/subdivision/test/loose_tets.hpp"

#include <gtest/gtest.h>

namespace cleave::subdivision {
namespace {

TEST(MillionTets, RandomTetsAndPlanes) {
    test::Random random(2025);
    EXPECT_GT(test::cut_loose_tets(random, 4000), 600'000);  // of 10^6; planes near the middle of the cloud cut most
}

}  // namespace
}  // namespace cleave::subdivision
