#pragma once

#include "solver/fragments/link_blocks.hpp"
#include "solver/subdivision/subdivided.hpp"
#include "solver/subdivision/subdivision_engine.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numeric>
#include <span>
#include <vector>

namespace cleave::fragments {

/// An extra link (two half faces that share a part) and whether a crack removed it.
struct PartialLink {
    subdivision::ExtraLink link;
    bool removed = false;
};

/// Who is still linked to whom. Particles and half faces (4 * particle + face) are numbered as by the engine. The engine knows which
/// faces touch; this table knows which of those links cracks have removed, and passes that on to the pieces when a tet is
/// subdivided later: a piece is unlinked from what its parent was unlinked from.
class LinkTable {
public:
    explicit LinkTable(const subdivision::SubdivisionEngine& engine);

    /// As after construction. The engine must be whole.
    void reset();

    /// Call after each cut of the engine: links of the new children.
    void take_over(const subdivision::SubdivisionEngine& engine);

    /// The half face behind an equal face, removed or not; -1 at the body's boundary and where faces do not conform. A subdivided
    /// original may still be named by its whole neighbours: ask is_gone.
    int opposite(const subdivision::SubdivisionEngine& engine, int half_face) const {
        const int particle = half_face / 4;
        return particle < originals() ? own_[static_cast<std::size_t>(particle)][half_face % 4]
                                      : engine.child_links()[static_cast<std::size_t>(particle - originals())][half_face % 4];
    }
    bool is_removed(int half_face) const { return (state_[static_cast<std::size_t>(half_face / 4)] >> half_face % 4 & 1U) != 0; }
    bool is_gone(int particle) const { return (state_[static_cast<std::size_t>(particle)] & gone) != 0; }
    const std::vector<PartialLink>& partial() const { return partial_; }
    int originals() const { return static_cast<int>(own_.size()); }
    int particles() const { return static_cast<int>(state_.size()); }

    /// Calls visit(particle, neighbour) for each link over an equal face to a particle for which wanted(particle, neighbour) holds;
    /// particles ascending.
    template <class Start, class Wanted, class Visit>
    void for_each_link(const subdivision::SubdivisionEngine& engine, std::span<const int> particles, const Start& start, const Wanted& wanted,
                       const Visit& visit) const {
        const std::uint8_t* state = state_.data();
        for (const int particle : particles) {
            start(particle);
            const std::array<int, 4>& behind = particle < originals() ? own_[particle] : engine.child_links()[particle - originals()];
            const unsigned removed = state[particle];
            // First gathered without a branch, because which faces qualify cannot be foretold.
            std::array<int, 4> neighbours;
            int count = 0;
            for (int face = 0; face < 4; ++face) {
                const int neighbour = behind[face] >> 2;  // -1 stays -1
                const int safe = neighbour & ~(neighbour >> 31);
                neighbours[count] = neighbour;
                count += static_cast<int>((neighbour >= 0) & wanted(particle, safe) & ((removed >> face & 1U) == 0) & ((state[safe] & gone) == 0));
            }
            for (int i = 0; i < count; ++i) visit(particle, neighbours[i]);
        }
    }

    /// Whether particles in a row, from the first on, have none of these links removed (bit per face).
    bool has_all(int first, std::span<const std::uint8_t> faces) const {
        const std::uint8_t* state = &state_[static_cast<std::size_t>(first)];
        unsigned removed = 0;
        for (std::size_t i = 0; i < faces.size(); ++i) removed |= static_cast<unsigned>(state[i] & faces[i]);
        return removed == 0;
    }

    const LinkBlocks& blocks() const { return blocks_; }
    /// Whether none of a block's tets was subdivided or lost a link.
    bool is_untouched(int block) const {
        std::array<std::uint64_t, LinkBlocks::size / 8> states;
        std::memcpy(states.data(), &state_[static_cast<std::size_t>(block) * LinkBlocks::size], sizeof states);
        return std::accumulate(states.begin(), states.end(), std::uint64_t{0}, std::bit_or<>()) == 0;
    }

    /// Removes the link over an equal face, from both sides.
    void remove(const subdivision::SubdivisionEngine& engine, int half_face);
    void remove_partial(std::size_t index) { partial_[index].removed = true; }

private:
    static constexpr std::uint8_t gone = 16;
    int before_cut(const subdivision::SubdivisionEngine& engine, int half_face) const;
    bool was_removed(const subdivision::SubdivisionEngine& engine, int first, int second) const;
    void pass_on_removals(const subdivision::SubdivisionEngine& engine, int parent);

    subdivision::LargeVector<std::array<int, 4>> own_;  ///< per original tet: behind each face, in the tet's own order of faces
    LinkBlocks blocks_;
    subdivision::LargeVector<std::uint8_t> state_;            ///< per particle: bits 0..3 removed links, `gone`: subdivided
    std::vector<PartialLink> partial_;                  ///< of all cuts, in the engine's order
    std::vector<std::uint64_t> removed_pairs_;          ///< removed partial links before the current cut, sorted
    subdivision::Buffer<subdivision::ExtraLink> scratch_;
};

}  // namespace cleave::fragments
