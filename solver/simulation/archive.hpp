#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace cleave::simulation {

/// Bytes to be read back by the same program: numbers as they lie in memory (little endian), lists after their length. A struct is
/// described once, for both directions, by a function `fields(archive, value)` in its namespace that calls archive(a, b, c, ...).
class ArchiveWriter {
public:
    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }
    const std::string& bytes() const { return bytes_; }

private:
    template <class Value>
    void put(const Value& value) {
        if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) raw(&value, sizeof value);
        else fields(*this, const_cast<Value&>(value));
    }
    void put(const std::string& text) {
        (*this)(static_cast<std::uint64_t>(text.size()));
        raw(text.data(), text.size());
    }
    template <class Value>
    void put(const std::vector<Value>& values) {
        (*this)(static_cast<std::uint64_t>(values.size()));
        for (const Value& value : values) put(value);
    }
    template <class Value, std::size_t count>
    void put(const std::array<Value, count>& values) {
        for (const Value& value : values) put(value);
    }
    template <class First, class Second>
    void put(const std::pair<First, Second>& pair) {
        (*this)(pair.first, pair.second);
    }
    template <class Value>
    void put(const std::optional<Value>& value) {
        (*this)(value.has_value());
        if (value) put(*value);
    }
    template <class Value, int rows, int columns>
    void put(const Eigen::Matrix<Value, rows, columns>& matrix) {
        raw(matrix.data(), sizeof(Value) * static_cast<std::size_t>(matrix.size()));
    }
    void raw(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }

    std::string bytes_;
};

/// Reads what ArchiveWriter wrote. Throws std::runtime_error where the bytes end too early or cannot be what it wrote.
class ArchiveReader {
public:
    explicit ArchiveReader(std::string_view bytes) : bytes_(bytes) {}
    template <class... Values>
    void operator()(Values&... values) {
        (get(values), ...);
    }
    bool at_end() const { return bytes_.empty(); }

private:
    template <class Value>
    void get(Value& value) {
        if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) raw(&value, sizeof value);
        else fields(*this, value);
    }
    void get(bool& value) {
        std::uint8_t byte = 0;  // a bool of any other value than 0 and 1 is undefined behaviour
        raw(&byte, sizeof byte);
        if (byte > 1) throw std::runtime_error("a truth value of neither 0 nor 1");
        value = byte == 1;
    }
    std::size_t length() {
        std::uint64_t size = 0;
        get(size);
        if (size > bytes_.size()) throw std::runtime_error("a list longer than the file");  // an entry takes a byte at least
        return static_cast<std::size_t>(size);
    }
    void get(std::string& text) {
        text.resize(length());
        raw(text.data(), text.size());
    }
    template <class Value>
    void get(std::vector<Value>& values) {
        // One after the other: a wrong length meets the end of the bytes before it has asked for much memory.
        values.clear();
        for (std::size_t left = length(); left > 0; --left) get(values.emplace_back());
    }
    template <class Value, std::size_t count>
    void get(std::array<Value, count>& values) {
        for (Value& value : values) get(value);
    }
    template <class First, class Second>
    void get(std::pair<First, Second>& pair) {
        (*this)(pair.first, pair.second);
    }
    template <class Value>
    void get(std::optional<Value>& value) {
        bool has = false;
        get(has);
        value.reset();
        if (has) get(value.emplace());
    }
    template <class Value, int rows, int columns>
    void get(Eigen::Matrix<Value, rows, columns>& matrix) {
        raw(matrix.data(), sizeof(Value) * static_cast<std::size_t>(matrix.size()));
    }
    void raw(void* data, std::size_t size) {
        if (size > bytes_.size()) throw std::runtime_error("bytes that end too early");
        std::memcpy(data, bytes_.data(), size);
        bytes_.remove_prefix(size);
    }

    std::string_view bytes_;
};

}  // namespace cleave::simulation
