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

    Value* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(Value);
        if (bytes < page) return static_cast<Value*>(::operator new(bytes, std::align_val_t{64}));
        void* memory = ::operator new(bytes, std::align_val_t{page});
        ::madvise(memory, bytes, MADV_HUGEPAGE);
        return static_cast<Value*>(memory);
    }
    void deallocate(Value* memory, std::size_t count) {
        ::operator delete(memory, std::align_val_t{count * sizeof(Value) < page ? 64 : page});
    }
    friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) { return true; }
};

template <class Value>
using LargeVector = std::vector<Value, HugePageAllocator<Value>>;

}  // namespace cleave::subdivision
