#include "solver/mesh/vtu_data.hpp"

#include "solver/input/input_error.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace cleave::mesh {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are read as they stand");

constexpr std::string_view blanks = " \t\r\n";
/// No array of a mesh that our indices can hold is larger; a broken length must not ask for more memory.
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 36;
/// zlib cannot pack tighter than 1 to 1032 (zlib's "Technical details"); a block that promises more is broken.
constexpr std::uint64_t most_expansion = 1032;

class ArrayReader {
public:
    ArrayReader(const XmlTag& array, const VtuStorage& storage) : array_(array), storage_(storage) {}

    std::vector<double> read() const {
        const std::string format = attribute("format", "ascii");
        if (format == "ascii") return read_ascii();
        if (format == "binary") return numbers(blocks(without_blanks(array_.text), true));
        if (format == "appended") return numbers(blocks(appended(), storage_.appended_is_base64));
        fail("format", fmt::format("ascii, binary or appended, not '{}'", format));
    }

private:
    [[noreturn]] void fail(const std::string& key, const std::string& expected) const {
        throw InputError(storage_.file, array_.line, fmt::format("DataArray {}: {}", attribute("Name", ""), key), expected);
    }

    std::string attribute(const std::string& name, const std::string& fallback) const {
        const auto found = array_.attributes.find(name);
        return found == array_.attributes.end() ? fallback : found->second;
    }

    std::vector<double> read_ascii() const {
        std::vector<double> values;
        std::string_view text = array_.text;
        for (std::size_t from = text.find_first_not_of(blanks); from != std::string_view::npos; from = text.find_first_not_of(blanks)) {
            text.remove_prefix(from);
            const std::string_view word = text.substr(0, text.find_first_of(blanks));
            double value = 0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
            if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) {
                fail("data", fmt::format("finite numbers, not '{}'", word.substr(0, 40)));
            }
            values.push_back(value);
            text.remove_prefix(word.size());
        }
        return values;
    }

    static std::string without_blanks(std::string_view text) {
        std::string kept;
        std::copy_if(text.begin(), text.end(), std::back_inserter(kept), [](char c) { return blanks.find(c) == std::string_view::npos; });
        return kept;
    }

    std::string_view appended() const {
        const std::string offset = attribute("offset", "");
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(offset.data(), offset.data() + offset.size(), value);
        if (error != std::errc() || end != offset.data() + offset.size()) fail("offset", fmt::format("a number, not '{}'", offset));
        if (value >= storage_.appended.size()) fail("offset", fmt::format("a place in the file's AppendedData (it has {} bytes)", storage_.appended.size()));
        return storage_.appended.substr(value);
    }

    /// The first `count` bytes of a base64 stream, or of plain bytes.
    std::string head(std::string_view source, bool base64, std::uint64_t count) const {
        const std::uint64_t length = base64 ? encoded_length(count) : count;
        if (count > most_bytes || length > source.size()) fail("data", fmt::format("{} more bytes (the data ends early)", count));
        if (!base64) return std::string(source.substr(0, count));
        std::string bytes = decoded(source.substr(0, length));
        if (bytes.size() < count) fail("data", fmt::format("{} bytes of base64, not {}", count, bytes.size()));
        bytes.resize(count);
        return bytes;
    }

    static std::uint64_t encoded_length(std::uint64_t bytes) { return (bytes + 2) / 3 * 4; }

    std::string decoded(std::string_view text) const {
        static constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string bytes;
        std::uint32_t bits = 0;
        int have = 0;
        for (const char c : text.substr(0, text.find('='))) {
            const std::size_t digit = alphabet.find(c);
            if (digit == std::string_view::npos) fail("data", fmt::format("base64, not '{}'", c));
            bits = (bits << 6 | static_cast<std::uint32_t>(digit)) & 0xffffff;
            have += 6;
            if (have < 8) continue;
            have -= 8;
            bytes.push_back(static_cast<char>(bits >> have & 0xff));
        }
        return bytes;
    }

    std::uint64_t length_at(std::string_view bytes, std::size_t index) const {
        std::uint64_t value = 0;
        std::memcpy(&value, bytes.data() + index * storage_.header_bytes, storage_.header_bytes);
        return value;
    }

    /// An array is a length and its bytes; compressed: the number of blocks, their size, the size of the last (0: full), each
    /// block's compressed size, and in base64 a new stream for the blocks.
    std::string blocks(std::string_view source, bool base64) const {
        const std::size_t word = storage_.header_bytes;
        const std::uint64_t first = length_at(head(source, base64, word), 0);
        if (first > most_bytes) fail("data", fmt::format("a length that can be, not {}", first));
        if (!storage_.compressed) return head(source, base64, word + first).substr(word);
        const std::uint64_t table_bytes = (3 + first) * word;
        const std::string table = head(source, base64, table_bytes);
        source.remove_prefix(base64 ? encoded_length(table_bytes) : table_bytes);
        std::uint64_t packed_bytes = 0;
        for (std::uint64_t block = 0; block < first; ++block) packed_bytes += length_at(table, 3 + block);
        return unpacked(head(source, base64, packed_bytes), table, first);
    }

    std::string unpacked(std::string_view packed, std::string_view table, std::uint64_t count) const {
        std::string bytes;
        for (std::uint64_t block = 0; block < count; ++block) {
            const bool last = block + 1 == count;
            const std::uint64_t size = last && length_at(table, 2) != 0 ? length_at(table, 2) : length_at(table, 1);
            const std::uint64_t packed_size = length_at(table, 3 + block);
            if (packed_size > packed.size() || size > most_expansion * packed_size) fail("data", "block sizes that can be");
            std::string piece(size, '\0');
            uLongf made = size;
            const auto* from = reinterpret_cast<const Bytef*>(packed.data());
            if (::uncompress(reinterpret_cast<Bytef*>(piece.data()), &made, from, packed_size) != Z_OK || made != size) fail("data", "zlib blocks");
            bytes += piece;
            packed.remove_prefix(packed_size);
        }
        return bytes;
    }

    template <class Number>
    std::vector<double> converted(std::string_view bytes) const {
        if (bytes.size() % sizeof(Number) != 0) fail("data", "whole numbers of the array's type");
        std::vector<double> values(bytes.size() / sizeof(Number));
        for (std::size_t i = 0; i < values.size(); ++i) {
            Number number;
            std::memcpy(&number, bytes.data() + i * sizeof(Number), sizeof(Number));
            values[i] = static_cast<double>(number);
            if (!std::isfinite(values[i])) fail("data", "finite numbers");
        }
        return values;
    }

    std::vector<double> numbers(const std::string& bytes) const {
        const std::string type = attribute("type", "");
        if (type == "Float64") return converted<double>(bytes);
        if (type == "Float32") return converted<float>(bytes);
        if (type == "Int64") return converted<std::int64_t>(bytes);
        if (type == "UInt64") return converted<std::uint64_t>(bytes);
        if (type == "Int32") return converted<std::int32_t>(bytes);
        if (type == "UInt32") return converted<std::uint32_t>(bytes);
        if (type == "Int16") return converted<std::int16_t>(bytes);
        if (type == "UInt16") return converted<std::uint16_t>(bytes);
        if (type == "Int8") return converted<std::int8_t>(bytes);
        if (type == "UInt8") return converted<std::uint8_t>(bytes);
        fail("type", fmt::format("Float32, Float64, Int8 ... UInt64, not '{}'", type));
    }

    const XmlTag& array_;
    const VtuStorage& storage_;
};

}  // namespace

std::vector<double> vtu_numbers(const XmlTag& array, const VtuStorage& storage) { return ArrayReader(array, storage).read(); }

}  // namespace cleave::mesh
