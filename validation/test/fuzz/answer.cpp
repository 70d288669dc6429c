#include "validation/test/fuzz/answer.hpp"

#include "solver/input/input_error.hpp"

#include <fmt/format.h>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

namespace cleave::fuzz {

namespace {

constexpr rlim_t most_bytes = rlim_t{2} << 30;

void limit(int resource, rlim_t most) {
    const rlimit limits{most, most};
    ::setrlimit(resource, &limits);
}

}  // namespace

bool memory_is_limited() {
#ifdef __SANITIZE_ADDRESS__
    return false;
#else
    return true;
#endif
}

bool isolated(const std::function<void()>& work, const std::string& name) {
    std::fflush(nullptr);  // or both processes print it
    const pid_t child = ::fork();
    if (child < 0) throw EnvironmentError("no process can be started");
    if (child == 0) {
        if (memory_is_limited()) limit(RLIMIT_DATA, most_bytes);
        limit(RLIMIT_CORE, 0);
        work();
        std::exit(0);  // not _exit: the process's own folder goes
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) fmt::print(stderr, "{}: {}\n", name, ::strsignal(WTERMSIG(status)));
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

Answer answer_here(const Target& target, const std::string& bytes) try {
    return accepts(target, bytes) ? Answer::accepted : Answer::refused;
} catch (const std::exception& error) {
    fmt::print(stderr, "{}: not an InputError: {}\n", target.name, error.what());
    return Answer::survivor;
}

void limit_processor_time(long seconds) {
    const itimerval once{.it_interval = {}, .it_value = {.tv_sec = seconds, .tv_usec = 0}};
    ::setitimer(ITIMER_PROF, &once, nullptr);
}

Answer answer(const Target& target, const std::string& bytes, long seconds) {
    // Shared with the process that tries it; what it does not write there it has not survived to write.
    void* memory = ::mmap(nullptr, sizeof(Answer), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw EnvironmentError("no memory can be shared");
    auto* const shared = new (memory) Answer(Answer::survivor);
    const bool whole = isolated([&] {
        limit_processor_time(seconds);
        *shared = answer_here(target, bytes);
    }, target.name);
    const Answer found = whole ? *shared : Answer::survivor;
    ::munmap(memory, sizeof(Answer));
    return found;
}

}  // namespace cleave::fuzz
