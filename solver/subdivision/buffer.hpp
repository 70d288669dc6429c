#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace cleave::subdivision {

/// A growing array of plain values that never writes what its user will write: new elements are uninitialised, and clear()
/// keeps the memory, so that a second use touches no new page.
template <class Value>
class Buffer {
    static_assert(std::is_trivially_copyable_v<Value>);

public:
    std::size_t size() const { return size_; }
    Value* data() { return values_.get(); }
    const Value* data() const { return values_.get(); }
    Value& operator[](std::size_t i) { return values_[i]; }
    const Value& operator[](std::size_t i) const { return values_[i]; }
    const Value* begin() const { return data(); }
    const Value* end() const { return data() + size_; }

    void clear() { size_ = 0; }
    void push_back(const Value& value) {
        resize(size_ + 1);
        values_[size_ - 1] = value;
    }
    void resize(std::size_t size) {
        if (size > capacity_) grow(std::max(size, 2 * capacity_));
        size_ = size;
    }

private:
    void grow(std::size_t capacity) {
        auto values = std::make_unique_for_overwrite<Value[]>(capacity);
        std::copy_n(values_.get(), size_, values.get());
        values_ = std::move(values);
        capacity_ = capacity;
    }

    std::unique_ptr<Value[]> values_;
    std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace cleave::subdivision
