#include "solver/parallel/workers.hpp"

#include "solver/parallel/arena.hpp"

namespace cleave::parallel {

Workers::Workers(int threads) : arena_(threads == 1 ? nullptr : std::make_unique<Arena>(threads)) {}
Workers::~Workers() = default;
Workers::Workers(Workers&&) noexcept = default;
Workers& Workers::operator=(Workers&&) noexcept = default;

void Workers::for_chunks(std::size_t chunks, const std::function<void(std::size_t)>& work) const {
    if (alone() || chunks < 2) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) work(chunk);
        return;
    }
    arena_->for_ranges(chunks, 1, [&work](std::size_t first, std::size_t last) {
        for (std::size_t chunk = first; chunk != last; ++chunk) work(chunk);
    });
}

}  // namespace cleave::parallel
