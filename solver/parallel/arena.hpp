#pragma once

#include "solver/parallel/for_each.hpp"

#include <cstddef>
#include <memory>

namespace cleave::parallel {

/// An arena of oneTBB, whose headers stay in arena.cpp: loops in it use at most its threads.
class Arena {
public:
    /// At most so many threads; 0: all that oneTBB offers to who makes this.
    explicit Arena(int threads);
    ~Arena();
    /// As parallel::for_ranges, by this arena's threads.
    void for_ranges(std::size_t count, std::size_t grain, const RangeWork& work) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace cleave::parallel
