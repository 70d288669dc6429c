#pragma once

#include <cstddef>
#include <functional>

namespace cleave::validation {

/// Runs work(0) ... work(count - 1), each once, on `jobs` child processes that take the next number as they get free. Processes, because
/// Gmsh and MPI hold state of the whole process. Nothing may have started threads, Gmsh or MPI before. Each child uses `threads` threads, its
/// share of the cores where that is 0. Returns 0, or the exit code of the first child that failed (its exception is one line on stderr, as from
/// run_program); the other children are then ended.
int run_in_processes(std::size_t count, int jobs, int threads, const std::function<void(std::size_t)>& work);

/// A counter that children of this process share.
class SharedCounter {
public:
    SharedCounter();
    ~SharedCounter();
    SharedCounter(const SharedCounter&) = delete;
    SharedCounter& operator=(const SharedCounter&) = delete;
    std::size_t next();        ///< the value before it grows by one
    std::size_t value() const;

private:
    void* memory_;
};

}  // namespace cleave::validation
