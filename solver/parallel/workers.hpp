#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace cleave::parallel {

class Arena;

/// Threads that share out chunks of work.
class Workers {
public:
    /// At most so many threads; 0: all that oneTBB offers to who makes this.
    explicit Workers(int threads);
    ~Workers();
    Workers(Workers&&) noexcept;
    Workers& operator=(Workers&&) noexcept;

    bool alone() const { return arena_ == nullptr; }
    /// work(chunk) for 0 .. chunks-1, in any order and at the same time: the calls must not depend on each other.
    void for_chunks(std::size_t chunks, const std::function<void(std::size_t)>& work) const;

private:
    std::unique_ptr<Arena> arena_;  ///< none for one thread
};

}  // namespace cleave::parallel
