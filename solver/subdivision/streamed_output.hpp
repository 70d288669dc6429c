#pragma once

#include "solver/subdivision/child_writer.hpp"

#include <immintrin.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace cleave::subdivision {

/// An array on its way to memory: elements are gathered in a small buffer that stays in the first-level cache, whole lines then go past the
/// caches. An ordinary store to a line that is in no cache first reads it from memory, which for large outputs is half of all traffic.
/// Writes no byte but those of its elements: several threads may write neighbouring parts of an array.
template <class Value, std::size_t most>
class StreamedArray {
public:
    /// `destination`: of the first element.
    explicit StreamedArray(Value* destination) {
        skipped_ = filled_ = reinterpret_cast<std::uintptr_t>(destination) % line;
        lines_ = reinterpret_cast<std::byte*>(destination) - filled_;
    }
    /// Where the next elements go; at most `most` of them, and less than a line over.
    Value* next() { return reinterpret_cast<Value*>(gathered_.data() + filled_); }
    /// So many elements were written.
    void pass_on(std::size_t count) {
        filled_ += count * sizeof(Value);
        const std::size_t whole = filled_ / line * line;
        if (whole == 0) return;
        std::size_t at = 0;
        if (skipped_ != 0) {
            store(skipped_, line);
            skipped_ = 0;
            at = line;
        }
        for (; at < whole; at += sizeof(__m256i)) {
            const auto* from = reinterpret_cast<const __m256i*>(gathered_.data() + at);
            _mm256_stream_si256(reinterpret_cast<__m256i*>(lines_ + at), _mm256_load_si256(from));
        }
        std::memcpy(gathered_.data(), gathered_.data() + whole, line);
        lines_ += whole;
        filled_ -= whole;
    }
    /// After the last element.
    void finish() { store(skipped_, filled_); }

private:
    static constexpr std::size_t line = 64;
    void store(std::size_t first, std::size_t last) { std::memcpy(lines_ + first, gathered_.data() + first, last - first); }

    alignas(line) std::array<std::byte, 3 * line + most * sizeof(Value)> gathered_;
    std::byte* lines_;     ///< where the first line of those gathered goes
    std::size_t filled_;   ///< bytes gathered, those skipped included
    std::size_t skipped_;  ///< bytes of the first line before the first element
};

/// The arrays of children, written from some child on.
class StreamedChildren {
public:
    static constexpr std::size_t parents_at_a_time = 16;  ///< the children of so many fill half of a first-level cache

    explicit StreamedChildren(const ChildArrays& to)
        : tets_(to.tets), links_(to.links), centroids_(to.centroids), volumes_(to.volumes), parents_(to.parents) {}

    /// Where the next children go, those of parents_at_a_time at most. `points` as in ChildArrays: these are not gathered.
    ChildArrays next(std::array<double, 3>* points) {
        return {tets_.next(), links_.next(), centroids_.next(), volumes_.next(), parents_.next(), points};
    }
    void pass_on(std::size_t children) {
        tets_.pass_on(children);
        links_.pass_on(children);
        centroids_.pass_on(children);
        volumes_.pass_on(children);
        parents_.pass_on(children);
    }
    void finish() {
        tets_.finish();
        links_.finish();
        centroids_.finish();
        volumes_.finish();
        parents_.finish();
        _mm_sfence();
    }

private:
    static constexpr std::size_t most = parents_at_a_time * PieceTable::most_children;
    StreamedArray<std::array<int, 4>, most> tets_, links_;
    StreamedArray<std::array<double, 3>, most> centroids_;
    StreamedArray<double, most> volumes_;
    StreamedArray<int, most> parents_;
};

}  // namespace cleave::subdivision
