// Faults on purpose, one per call: each tool has to report its own, or it is switched off. sanitizers.sh calls them.
//   sanitizer_twin heap_overflow|signed_overflow|float_overflow|leak|uninitialised|data_race|loop_race|none

#include "solver/parallel/workers.hpp"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <thread>

namespace {

int heap_overflow(int last) {
    const auto values = std::make_unique<int[]>(static_cast<std::size_t>(last));
    return values[static_cast<std::size_t>(last)];
}

int signed_overflow(int more) { return std::numeric_limits<int>::max() - 1 + more; }

int float_overflow(int more) { return static_cast<int>(1e9 * more); }

int leak(int count) {
    int* volatile lost = new int[static_cast<std::size_t>(count)]{};
    const int value = lost[0];
    lost = nullptr;
    return value;  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): the fault planted here
}

int uninitialised(int count) {
    int* values = static_cast<int*>(std::malloc(static_cast<std::size_t>(count) * sizeof(int)));
    const int* volatile seen = values;
    const int answer = seen[count - 1] > 0 ? 1 : 2;
    std::free(values);
    return answer;
}

/// Both threads are here at once. Without order between them: relaxed atomics make none.
void meet(std::atomic<int>& arrived) {
    const auto late = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    arrived.fetch_add(1, std::memory_order_relaxed);
    while (arrived.load(std::memory_order_relaxed) < 2 && std::chrono::steady_clock::now() < late) std::this_thread::yield();
}

int data_race() {
    int sum = 0;
    std::atomic<int> arrived = 0;
    const auto add = [&] { meet(arrived); ++sum; };
    std::thread other(add);
    add();
    other.join();
    return sum;
}

/// What ForkJoin tells the thread sanitizer must not hide races between the calls of one loop.
int loop_race() {
    int sum = 0;
    std::atomic<int> arrived = 0;
    cleave::parallel::Workers(2).for_chunks(2, [&](std::size_t) { meet(arrived); ++sum; });
    return sum;
}

}  // namespace

int main(int count, char** words) {
    const std::string fault = count > 1 ? words[1] : "";
    const int opaque = static_cast<int>(fault.size());  // the compiler does not know it
    int answer = 0;
    if (fault == "heap_overflow") answer = heap_overflow(opaque);
    else if (fault == "signed_overflow") answer = signed_overflow(opaque);
    else if (fault == "float_overflow") answer = float_overflow(opaque);
    else if (fault == "leak") answer = leak(opaque);
    else if (fault == "uninitialised") answer = uninitialised(opaque);
    else if (fault == "data_race") answer = data_race();
    else if (fault == "loop_race") answer = loop_race();
    else if (fault != "none") return 2;
    std::printf("%d\n", answer);
    return 0;
}
