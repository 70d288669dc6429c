#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cleave::subdivision {

/// A set of numbers below a fixed size, visited in ascending order: 64 numbers a word, and above each level one bit for a word
/// that is not empty. A few numbers among millions are found without reading the rest.
class SparseBits {
public:
    explicit SparseBits(std::size_t size = 0) {
        do {
            size = (size + 63) / 64;
            levels_.emplace_back(size, 0);
        } while (size > 1);
    }

    void set(std::size_t number) {
        for (auto& level : levels_) {
            std::uint64_t& word = level[number / 64];
            const bool was_empty = word == 0;
            word |= std::uint64_t{1} << number % 64;
            if (!was_empty) return;
            number /= 64;
        }
    }

    void reset(std::size_t number) {
        for (auto& level : levels_) {
            std::uint64_t& word = level[number / 64];
            word &= ~(std::uint64_t{1} << number % 64);
            if (word != 0) return;
            number /= 64;
        }
    }

    std::size_t words() const { return levels_[0].size(); }
    std::uint64_t word(std::size_t index) const { return levels_[0][index]; }

    /// Calls visit(index) for each word that is not empty, ascending.
    template <class Visit>
    void for_each_word(const Visit& visit) const {
        walk_words(levels_.size() - 1, 0, visit);
    }

    bool test(std::size_t number) const { return (levels_[0][number / 64] >> number % 64 & 1U) != 0; }

    /// Calls visit(number) for each number, ascending.
    template <class Visit>
    void for_each(const Visit& visit) const {
        walk(levels_.size() - 1, 0, visit);
    }

    /// The same, and leaves the set empty.
    template <class Visit>
    void drain(const Visit& visit) {
        drain_level(levels_.size() - 1, 0, visit);
    }

private:
    template <class Visit>
    void walk(std::size_t level, std::size_t word, const Visit& visit) const {
        if (word >= levels_[level].size()) return;
        for (std::uint64_t bits = levels_[level][word]; bits != 0; bits &= bits - 1) {
            const std::size_t number = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
            level == 0 ? visit(number) : walk(level - 1, number, visit);
        }
    }

    template <class Visit>
    void walk_words(std::size_t level, std::size_t word, const Visit& visit) const {
        if (word >= levels_[level].size() || levels_[level][word] == 0) return;
        if (level == 0) {
            visit(word);
            return;
        }
        for (std::uint64_t bits = levels_[level][word]; bits != 0; bits &= bits - 1) {
            walk_words(level - 1, 64 * word + static_cast<std::size_t>(std::countr_zero(bits)), visit);
        }
    }

    template <class Visit>
    void drain_level(std::size_t level, std::size_t word, const Visit& visit) {
        if (word >= levels_[level].size()) return;
        std::uint64_t bits = levels_[level][word];
        levels_[level][word] = 0;
        for (; bits != 0; bits &= bits - 1) {
            const std::size_t number = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
            level == 0 ? visit(number) : drain_level(level - 1, number, visit);
        }
    }

    std::vector<std::vector<std::uint64_t>> levels_;  ///< [0] the numbers, each next one 64 times shorter
};

/// A SparseBits that tells a member's place among the members, in memory an eighth of a bit's array of numbers would need.
class RankedBits {
public:
    explicit RankedBits(std::size_t size = 0) : bits_(size), before_(bits_.words()) {}

    void set(std::size_t number) { bits_.set(number); }
    /// Call once all members are set; returns their count.
    int rank_all() {
        int count = 0;
        bits_.for_each_word([&](std::size_t word) {
            before_[word] = count;
            count += std::popcount(bits_.word(word));
        });
        return count;
    }
    /// How many members are smaller than this member.
    int rank(std::size_t number) const {
        const std::uint64_t smaller = (std::uint64_t{1} << number % 64) - 1;
        return before_[number / 64] + std::popcount(bits_.word(number / 64) & smaller);
    }
    template <class Visit>
    void for_each(const Visit& visit) const {
        bits_.for_each(visit);
    }
    void clear() {
        bits_.drain([](std::size_t) {});
    }

private:
    SparseBits bits_;
    std::vector<int> before_;  ///< per word: members in the words before it
};

}  // namespace cleave::subdivision
