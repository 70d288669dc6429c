#include "validation/processes.hpp"

#include "solver/input/input_error.hpp"
#include "solver/parallel/on_threads.hpp"

#include <fmt/format.h>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <thread>
#include <vector>

namespace cleave::validation {

namespace {

using Counter = std::atomic<std::size_t>;
static_assert(Counter::is_always_lock_free);

int guarded(const std::function<void()>& body) try {
    body();
    return 0;
} catch (const InputError& error) {
    fmt::print(stderr, "cleave validate: {}\n", error.what());
    return static_cast<int>(ExitCode::input);
} catch (const EnvironmentError& error) {
    fmt::print(stderr, "cleave validate: {}\n", error.what());
    return static_cast<int>(ExitCode::environment);
} catch (const std::exception& error) {
    fmt::print(stderr, "cleave validate: internal error: {}\n", error.what());
    return static_cast<int>(ExitCode::bug);
}

[[noreturn]] void child(std::size_t count, int threads, SharedCounter& counter, const std::function<void(std::size_t)>& work) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // a parent that is killed leaves nothing running; libraries (METIS) catch SIGTERM
    const int code = guarded([&] {
        parallel::on_threads(threads, [&] {
            for (std::size_t i = counter.next(); i < count; i = counter.next()) work(i);
        });
    });
    std::fflush(nullptr);
    ::_exit(code);  // without the parent's destructors
}

int exit_code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : static_cast<int>(ExitCode::bug); }

/// Waits for all; ends the rest when one fails.
int wait_for(std::vector<pid_t> children) {
    int failure = 0;
    while (!children.empty()) {
        int status = 0;
        const pid_t ended = ::wait(&status);
        if (ended < 0) break;
        std::erase(children, ended);
        if (failure != 0 || exit_code_of(status) == 0) continue;
        failure = exit_code_of(status);
        if (WIFSIGNALED(status)) fmt::print(stderr, "cleave validate: internal error: a process ended by signal {}\n", WTERMSIG(status));
        for (const pid_t other : children) ::kill(other, SIGKILL);
    }
    return failure;
}

}  // namespace

SharedCounter::SharedCounter()
    : memory_(::mmap(nullptr, sizeof(Counter), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ == MAP_FAILED) throw EnvironmentError("no memory to share between processes");
    new (memory_) Counter(0);
}

SharedCounter::~SharedCounter() { ::munmap(memory_, sizeof(Counter)); }
std::size_t SharedCounter::next() { return static_cast<Counter*>(memory_)->fetch_add(1); }
std::size_t SharedCounter::value() const { return static_cast<const Counter*>(memory_)->load(); }

int run_in_processes(std::size_t count, int jobs, int threads, const std::function<void(std::size_t)>& work) {
    if (threads == 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / jobs);
    std::fflush(nullptr);  // what is buffered would be written by every child
    SharedCounter counter;
    std::vector<pid_t> children;
    for (int i = 0; i < jobs; ++i) {
        const pid_t made = ::fork();
        if (made == 0) child(count, threads, counter, work);
        if (made < 0) break;
        children.push_back(made);
    }
    if (children.empty()) throw EnvironmentError("no process could be started");
    return wait_for(std::move(children));
}

}  // namespace cleave::validation
