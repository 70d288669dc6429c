#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <vector>

namespace cleave::subdivision {

/// Allocates large arrays on huge pages where the system allows it: scattered reads of millions of tets otherwise wait for
/// the address translation. Only a hint; where it is refused, nothing else changes.
template <class Value>
struct HugePageAllocator {
    using value_type = Value;
    HugePageAllocator() = default;
    template <class Other>
    HugePageAllocator(const HugePageAllocator<Other>&) {}

    static constexpr std::size_t page = std::size_t{1} << 21;
    /// Clearing one huge page takes the system about as long as handing out the small ones of a quarter.
    static constexpr bool is_large(std::size_t bytes) { return bytes >= page / 4; }

    Value* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(Value);
        if (!is_large(bytes)) return static_cast<Value*>(::operator new(bytes, std::align_val_t{64}));
        // Whole pages: the tail, or all of an array somewhat smaller than a page, would lie on small ones otherwise.
        const std::size_t whole = (bytes + page - 1) / page * page;
        void* memory = ::operator new(whole, std::align_val_t{page});
        ::madvise(memory, whole, MADV_HUGEPAGE);
        return static_cast<Value*>(memory);
    }
    void deallocate(Value* memory, std::size_t count) {
        ::operator delete(memory, std::align_val_t{is_large(count * sizeof(Value)) ? page : 64});
    }
    friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) { return true; }
};

template <class Value>
using LargeVector = std::vector<Value, HugePageAllocator<Value>>;

}  // namespace cleave::subdivision
