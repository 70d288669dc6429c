#pragma once

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <cstddef>

namespace cleave::parallel {

/// Returns work(), which may use up to `threads` > 0 threads of oneTBB, however many cores there are: an arena of its own, since the usual one
/// has only as many places as the machine has cores.
template <class Work>
decltype(auto) on_threads(int threads, const Work& work) {
    namespace tbb = oneapi::tbb;
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute(work);
}

}  // namespace cleave::parallel
