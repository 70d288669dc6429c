#include "solver/subdivision/workers.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace cleave::subdivision {

struct Workers::Arena {
    mutable tbb::task_arena arena;
};

Workers::Workers(int threads) {
    if (threads == 1) return;
    arena_ = std::make_unique<Arena>();
    arena_->arena.initialize(threads == 0 ? tbb::this_task_arena::max_concurrency() : threads);
}

Workers::~Workers() = default;
Workers::Workers(Workers&&) noexcept = default;
Workers& Workers::operator=(Workers&&) noexcept = default;

void Workers::for_chunks(std::size_t chunks, const std::function<void(std::size_t)>& work) const {
    if (alone() || chunks < 2) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) work(chunk);
        return;
    }
    arena_->arena.execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks), [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t chunk = range.begin(); chunk != range.end(); ++chunk) work(chunk);
        });
    });
}

}  // namespace cleave::subdivision
