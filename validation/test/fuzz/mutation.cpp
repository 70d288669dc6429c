#include "validation/test/fuzz/mutation.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "validation/test/fuzz/answer.hpp"

#include <fmt/format.h>

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace cleave::fuzz {

namespace {

constexpr std::size_t longest_input = 65536, most_parents = 400;

/// Where readers of numbers go wrong.
constexpr std::array<std::string_view, 26> odd_words{
    "0", "-1", "1", "-0.0", "0.5", "1e308", "-1e308", "1e-320", "1e999", "nan", "inf", "-inf", "2147483648", "4294967297", "-2147483648",
    "9223372036854775807", "-9223372036854775808", "18446744073709551615", "99999999999999999999999", "0x10", "1_000", "true", "null", "\"\"", "{}", "[]"};
constexpr std::array<std::uint64_t, 10> odd_integers{0, 1, 2, 0x7f, 0x80, 0xff, 0x7fffffff, 0x80000000, 0x7fffffffffffffff, 0xffffffffffffffff};

bool of_a_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("+-._", c) != nullptr; }

struct Range {
    std::size_t begin = 0, size = 0;
};

/// The word around or behind a place; empty where none follows.
Range word_at(const std::string& text, std::size_t at) {
    while (at < text.size() && !of_a_word(text[at])) ++at;
    std::size_t begin = at;
    while (begin > 0 && of_a_word(text[begin - 1])) --begin;
    while (at < text.size() && of_a_word(text[at])) ++at;
    return {begin, at - begin};
}

/// The line around a place, with its end.
Range line_at(const std::string& text, std::size_t at) {
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1, end = text.find('\n', at);
    return {begin, (end == std::string::npos ? text.size() : end + 1) - begin};
}

}  // namespace

void Mutator::damage_bytes(std::string& text) {
    const std::size_t at = below(text.size());
    switch (below(4)) {
        case 0: text[at] = static_cast<char>(text[at] ^ (1 << below(8))); return;
        case 1: text[at] = static_cast<char>(random_()); return;
        case 2: text.insert(at, 1, static_cast<char>(random_())); return;
        default: {
            const std::uint64_t value = odd_integers[below(odd_integers.size())];
            const std::size_t size = std::min<std::size_t>(std::size_t{1} << below(4), text.size() - at);
            std::memcpy(text.data() + at, &value, size);
        }
    }
}

void Mutator::damage_range(std::string& text) {
    const std::size_t at = below(text.size()), size = 1 + below(std::min<std::size_t>(text.size() - at, 64));
    const std::string& other = parents_[below(parents_.size())];
    switch (below(4)) {
        case 0: text.erase(at, size); return;
        case 1: text.insert(at, text.substr(at, size)); return;
        case 2: text.resize(at); return;
        default: text.replace(at, size, other.substr(below(other.size()), 1 + below(64)));
    }
}

void Mutator::damage_words(std::string& text) {
    const Range word = word_at(text, below(text.size()));
    if (below(2) == 0) {
        text.replace(word.begin, word.size, odd_words[below(odd_words.size())]);
        return;
    }
    const std::string& other = parents_[below(parents_.size())];
    const Range taken = word_at(other, below(other.size()));
    text.replace(word.begin, word.size, other.substr(taken.begin, taken.size));
}

void Mutator::damage_lines(std::string& text) {
    const Range line = line_at(text, below(text.size()));
    const std::string& other = parents_[below(parents_.size())];
    const Range taken = line_at(other, below(other.size()));
    switch (below(3)) {
        case 0: text.erase(line.begin, line.size); return;
        case 1: text.insert(line.begin, text.substr(line.begin, line.size)); return;
        default: text.insert(line.begin, other.substr(taken.begin, taken.size));
    }
}

void Mutator::damage(std::string& text) {
    if (text.empty()) text.assign(1, ' ');
    constexpr std::array kinds{&Mutator::damage_bytes, &Mutator::damage_range, &Mutator::damage_words, &Mutator::damage_lines};
    (this->*kinds[below(kinds.size())])(text);
}

std::string Mutator::next() {
    std::string text = parents_[below(parents_.size())];
    for (std::size_t left = 1 + below(4); left > 0; --left) damage(text);
    if (text.size() > longest_input) text.resize(longest_input);
    return text;
}

void Mutator::keep(const std::string& input) {
    if (parents_.size() < most_parents) parents_.push_back(input);
}

namespace {

/// What a process that tries a batch leaves behind, however it ends.
struct Shared {
    Tried tried;
    std::size_t size = 0;                    ///< of the input it is at; 0 where it has come to the end of the batch
    std::array<char, longest_input> input{};
};

class SharedMemory {
public:
    SharedMemory() : memory_(::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
        if (memory_ == MAP_FAILED) throw EnvironmentError("no memory can be shared");
        shared_ = new (memory_) Shared;
    }
    ~SharedMemory() { ::munmap(memory_, sizeof(Shared)); }
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;
    Shared& operator*() const { return *shared_; }

private:
    void* memory_;
    Shared* shared_ = nullptr;
};

void try_batch(const Target& target, long count, std::uint64_t seed, Shared& shared) {
    constexpr long seconds = 10;
    Mutator mutator(target.seeds, seed);
    for (long i = 0; i < count; ++i) {
        const std::string input = mutator.next();
        std::memcpy(shared.input.data(), input.data(), input.size());
        shared.size = input.size();
        limit_processor_time(seconds);
        const Answer answer = answer_here(target, input);
        if (answer == Answer::survivor) std::exit(1);
        ++(answer == Answer::accepted ? shared.tried.accepted : shared.tried.refused);
        if (answer == Answer::accepted) mutator.keep(input);
    }
    shared.size = 0;
}

}  // namespace

Tried try_mutations(const Target& target, long count, std::uint64_t seed, const std::filesystem::path& finds) {
    constexpr long batch = 2000, most_survivors = 20;
    Tried tried;
    for (std::uint64_t number = 0; tried.all() < count && tried.survivors < most_survivors; ++number) {
        const SharedMemory memory;
        const long left = std::min(batch, count - tried.all());
        const bool whole = isolated([&] { try_batch(target, left, seed + 1'000'003 * number, *memory); }, target.name);
        const Shared& shared = *memory;
        tried.accepted += shared.tried.accepted;
        tried.refused += shared.tried.refused;
        if (whole && shared.size == 0) continue;
        ++tried.survivors;
        const std::filesystem::path file = finds / fmt::format("{}-{}", target.name, number);
        write_file_atomic(file, std::string_view(shared.input.data(), shared.size));
        fmt::print(stderr, "{}: kept as {}\n", target.name, file.string());
    }
    return tried;
}

}  // namespace cleave::fuzz
