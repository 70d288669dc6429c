// The one place where oneTBB runs loops. Under the thread sanitizer this file is not instrumented, as the library itself is not: else each
// hand-over of a task, whose locks the sanitizer does not see, would count as a race. ForkJoin tells it what the library guarantees.

#include "solver/parallel/arena.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#ifdef CLEAVE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace cleave::parallel {

namespace {

/// What stands before a loop happens before each of its calls, and these before what follows the loop. Between the calls it claims no
/// order, so that races among them are found.
class ForkJoin {
public:
    ForkJoin() { release(fork_); }
    ~ForkJoin() { acquire(join_); }
    ForkJoin(const ForkJoin&) = delete;
    ForkJoin& operator=(const ForkJoin&) = delete;

    /// One call of the loop's body, on any thread: from construction to destruction.
    class Call {
    public:
        explicit Call(ForkJoin& loop) : loop_(loop) { acquire(loop_.fork_); }
        ~Call() { release(loop_.join_); }
        Call(const Call&) = delete;
        Call& operator=(const Call&) = delete;

    private:
        ForkJoin& loop_;
    };

private:
#ifdef CLEAVE_THREAD_SANITIZER
    static void release(char& at) { __tsan_release(&at); }
    static void acquire(char& at) { __tsan_acquire(&at); }
#else
    static void release(char&) {}
    static void acquire(char&) {}
#endif
    char fork_ = 0, join_ = 0;  ///< their addresses name the two hand-overs
};

}  // namespace

struct Arena::Data {
    tbb::task_arena arena;
};

Arena::Arena(int threads) : data_(std::make_unique<Data>()) { data_->arena.initialize(threads == 0 ? tbb::this_task_arena::max_concurrency() : threads); }
Arena::~Arena() = default;

void Arena::for_ranges(std::size_t count, std::size_t grain, const RangeWork& work) const {
    data_->arena.execute([&] { parallel::for_ranges(count, grain, work); });
}

void for_ranges(std::size_t count, std::size_t grain, const RangeWork& work) {
    using Range = tbb::blocked_range<std::size_t>;
    ForkJoin loop;
    tbb::parallel_for(Range(0, count, grain), [&](const Range& range) {
        const ForkJoin::Call call(loop);
        work(range.begin(), range.end());
    });
}

}  // namespace cleave::parallel
