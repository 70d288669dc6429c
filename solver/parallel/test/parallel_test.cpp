#include "solver/parallel/for_each.hpp"
#include "solver/parallel/workers.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <numeric>
#include <stdexcept>
#include <vector>

namespace cleave::parallel {
namespace {

/// 1, 1, ..., 1: each index seen once.
std::vector<int> once(std::size_t count) { return std::vector<int>(count, 1); }

TEST(ForEach, CallsEachIndexOnce) {
    for (const int count : {0, 1, 1000}) {
        for (const std::size_t grain : {1, 7, 5000}) {
            std::vector<int> seen(static_cast<std::size_t>(count), 0);
            for_each(count, [&](int i) { ++seen[static_cast<std::size_t>(i)]; }, grain);
            EXPECT_EQ(seen, once(seen.size())) << count << " by " << grain;
        }
    }
}

TEST(ForEach, LoopsMayStandInLoops) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
    std::vector<std::vector<int>> seen(50, std::vector<int>(40, 0));
    for_each(seen.size(), [&](std::size_t i) {
        for_each(seen[i].size(), [&](std::size_t j) { ++seen[i][j]; });
        seen[i].push_back(std::accumulate(seen[i].begin(), seen[i].end(), 0));  // what the inner loop left is there
    });
    for (const std::vector<int>& row : seen) EXPECT_EQ(row.back(), 40);
}

TEST(ForEach, AnExceptionComesOut) {
    const auto throws_at_70 = [](int i) { if (i == 70) throw std::runtime_error("seventy"); };
    EXPECT_THROW(for_each(100, throws_at_70), std::runtime_error);
}

TEST(Workers, CallEachChunkOnceForAnyNumberOfThreads) {
    const tbb::global_control allow_more_than_processors(tbb::global_control::max_allowed_parallelism, 8);
    for (const int threads : {0, 1, 2, 8}) {
        const Workers workers(threads);
        EXPECT_EQ(workers.alone(), threads == 1);
        for (const std::size_t chunks : {0, 1, 2, 500}) {
            std::vector<int> seen(chunks, 0);
            workers.for_chunks(chunks, [&](std::size_t chunk) { ++seen[chunk]; });
            EXPECT_EQ(seen, once(chunks)) << threads << " threads";
        }
    }
}

}  // namespace
}  // namespace cleave::parallel
