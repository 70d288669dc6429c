// Inputs made from the seeds by small damage: no compiler or sanitizer of its own is needed, and none of it is by chance.
#pragma once

#include "validation/test/fuzz/target.hpp"

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace cleave::fuzz {

/// An endless row of damaged inputs, the same for the same seed.
class Mutator {
public:
    Mutator(std::vector<std::string> parents, std::uint64_t seed) : parents_(std::move(parents)), random_(seed) {}
    std::string next();
    /// An input worth damaging further.
    void keep(const std::string& input);

private:
    std::size_t below(std::size_t count) { return count == 0 ? 0 : static_cast<std::size_t>(random_() % count); }
    void damage(std::string& text);
    void damage_bytes(std::string& text);
    void damage_range(std::string& text);
    void damage_words(std::string& text);
    void damage_lines(std::string& text);

    std::vector<std::string> parents_;
    std::mt19937_64 random_;
};

struct Tried {
    long accepted = 0, refused = 0, survivors = 0;
    long all() const { return accepted + refused + survivors; }
};

/// Tries `count` of them, in processes of their own; each survivor goes to FINDS/TARGET-NUMBER.
Tried try_mutations(const Target& target, long count, std::uint64_t seed, const std::filesystem::path& finds);

}  // namespace cleave::fuzz
