#include "benchmarks/memory.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

namespace cleave::benchmarks {
namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;

TEST(PeakBytes, CountsWhatWasFreedAgainButNotWhatWasThereBefore) {
    const std::vector<char> before(256 * megabyte, 1);
    std::vector<char> used;
    const std::size_t peak = peak_bytes_of([&] {
        used.assign(64 * megabyte, 1);
        std::vector<char>().swap(used);
        used.assign(16 * megabyte, 1);
    });
    EXPECT_GE(peak, 63 * megabyte);
    EXPECT_LT(peak, 100 * megabyte);
    EXPECT_EQ(before.back() + used.back(), 2);
}

TEST(PeakBytes, CountsOnlyPagesThatWereWritten) {
    std::unique_ptr<char[]> half;
    const std::size_t peak = peak_bytes_of([&] {
        half.reset(new char[64 * megabyte]);
        std::memset(half.get(), 1, 32 * megabyte);
    });
    EXPECT_GE(peak, 31 * megabyte);
    EXPECT_LT(peak, 40 * megabyte);
    EXPECT_EQ(half[0], 1);
}

}  // namespace
}  // namespace cleave::benchmarks
