#pragma once

#include <concepts>
#include <cstddef>
#include <functional>

namespace cleave::parallel {

/// Work on the indices from `first` to before `last`.
using RangeWork = std::function<void(std::size_t first, std::size_t last)>;

/// work on ranges that are [0, count) together, of `grain` indices or more where possible, on all threads that oneTBB offers here, in any
/// order and at the same time. An exception of one ends the loop and comes out of it.
void for_ranges(std::size_t count, std::size_t grain, const RangeWork& work);

/// body(i) for i in [0, count) on all threads. The calls must be independent: then the result does not depend on the threads.
/// `grain`: how many calls are worth handing to another thread.
template <std::integral Index, class Body>
void for_each(Index count, const Body& body, std::size_t grain = 1) {
    const auto range = [&body](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i != last; ++i) body(static_cast<Index>(i));
    };
    for_ranges(static_cast<std::size_t>(count), grain, range);
}

}  // namespace cleave::parallel
