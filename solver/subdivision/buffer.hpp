#pragma once

#include "solver/subdivision/huge_pages.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace cleave::subdivision {

/// A growing array of plain values that never writes what its user will write: new elements are uninitialised, and clear()
/// keeps the memory, so that a second use touches no new page.
template <class Value>
class Buffer {
    static_assert(std::is_trivially_copyable_v<Value>);

public:
    Buffer() = default;
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    Buffer(Buffer&& other) noexcept
        : values_(std::exchange(other.values_, nullptr)), size_(std::exchange(other.size_, 0)), capacity_(std::exchange(other.capacity_, 0)) {}
    Buffer& operator=(Buffer&& other) noexcept {
        std::swap(values_, other.values_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        return *this;
    }
    ~Buffer() { free(); }

    std::size_t size() const { return size_; }
    Value* data() { return values_; }
    const Value* data() const { return values_; }
    Value& operator[](std::size_t i) { return values_[i]; }
    const Value& operator[](std::size_t i) const { return values_[i]; }
    const Value* begin() const { return data(); }
    const Value* end() const { return data() + size_; }

    void clear() { size_ = 0; }
    void push_back(const Value& value) {
        resize(size_ + 1);
        values_[size_ - 1] = value;
    }
    /// Appends so many elements, to be written by the caller; returns the first.
    Value* grow_by(std::size_t count) {
        resize(size_ + count);
        return values_ + (size_ - count);
    }
    void resize(std::size_t size) {
        if (size > capacity_) grow(std::max(size, 2 * capacity_));
        size_ = size;
    }

private:
    void grow(std::size_t capacity) {
        Value* values = HugePageAllocator<Value>().allocate(capacity);
        std::copy_n(values_, size_, values);
        free();
        values_ = values;
        capacity_ = capacity;
    }
    void free() {
        if (values_ != nullptr) HugePageAllocator<Value>().deallocate(values_, capacity_);
    }

    Value* values_ = nullptr;
    std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace cleave::subdivision
