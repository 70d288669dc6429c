#include "solver/subdivision/sparse_bits.hpp"

#include "solver/subdivision/test/random.hpp"

#include <gtest/gtest.h>

#include <set>

namespace cleave::subdivision {
namespace {

std::vector<std::size_t> listed(const SparseBits& bits) {
    std::vector<std::size_t> numbers;
    bits.for_each([&](std::size_t number) { numbers.push_back(number); });
    return numbers;
}

TEST(SparseBits, AgreeWithASet) {
    test::Random random(41);
    for (const std::size_t size : {1U, 63U, 64U, 65U, 4096U, 4097U, 300000U}) {
        SparseBits bits(size);
        std::set<std::size_t> expected;
        for (int i = 0; i < 2000; ++i) {
            const auto number = static_cast<std::size_t>(random.uniform(0, static_cast<double>(size)));
            if (i % 3 == 0) bits.reset(number), expected.erase(number);
            else bits.set(number), expected.insert(number);
            EXPECT_EQ(bits.test(number), expected.contains(number));
        }
        EXPECT_EQ(listed(bits), std::vector<std::size_t>(expected.begin(), expected.end()));
        std::vector<std::size_t> drained;
        bits.drain([&](std::size_t number) { drained.push_back(number); });
        EXPECT_EQ(drained, std::vector<std::size_t>(expected.begin(), expected.end()));
        EXPECT_TRUE(listed(bits).empty());
        bits.set(size - 1);
        EXPECT_EQ(listed(bits), std::vector<std::size_t>{size - 1});
    }
}

TEST(RankedBits, RanksArePlacesInOrder) {
    test::Random random(42);
    RankedBits bits(100000);
    for (const int members : {1, 70, 5000}) {
        std::set<std::size_t> expected;
        for (int i = 0; i < members; ++i) expected.insert(static_cast<std::size_t>(random.uniform(0, 100000)));
        for (const std::size_t number : expected) bits.set(number);
        EXPECT_EQ(bits.rank_all(), static_cast<int>(expected.size()));
        int place = 0;
        for (const std::size_t number : expected) EXPECT_EQ(bits.rank(number), place++);
        bits.clear();  // and of use again
    }
    EXPECT_EQ(bits.rank_all(), 0);
}

TEST(SparseBits, MayBeEmpty) {
    SparseBits bits(0);
    EXPECT_TRUE(listed(bits).empty());
    bits.drain([](std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace cleave::subdivision
