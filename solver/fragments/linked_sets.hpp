#pragma once

#include "solver/fragments/child_groups.hpp"
#include "solver/fragments/link_table.hpp"
#include "solver/fragments/union_find.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cleave::fragments {

/// Finds which particles hang together. What no crack has touched goes as one: the parts of a block of original tets (LinkBlocks), the
/// children of a parent on one side (ChildGroup); the rest goes particle by particle. Memory is kept between uses.
class LinkedSets {
public:
    /// `particles` (all of a fragment, ascending); `in_fragment(particle)` for the ends of partial links.
    template <class InFragment>
    void find(const subdivision::SubdivisionEngine& engine, const LinkTable& links, std::span<const int> particles, const InFragment& in_fragment) {
        prepare(engine, links, particles);
        for (const PartialLink& partial : links.partial()) {
            const int first = partial.link.first / 4, second = partial.link.second / 4;
            if (!partial.removed && in_fragment(first)) sets_.unite(set_of(links, first), set_of(links, second));
        }
        flatten(links, particles);
    }

    /// The smallest particle of the set that a particle belongs to.
    int look_up(int particle) const { return sets_.look_up(particle); }

private:
    /// Particles in a row: a block (>= 0) or a group that hang together, or some that go one by one.
    struct Run {
        int first, count;  ///< among the particles
        int block;
        const ChildGroup* group;
    };
    void find_runs(const subdivision::SubdivisionEngine& engine, const LinkTable& links, std::span<const int> particles);
    template <class InBlock, class InGroup, class OneByOne>
    void for_runs(std::span<const int> particles, const InBlock& in_block, const InGroup& in_group, const OneByOne& one_by_one) const;
    void prepare(const subdivision::SubdivisionEngine& engine, const LinkTable& links, std::span<const int> particles);
    void flatten(const LinkTable& links, std::span<const int> particles);
    bool in_parts(int particle) const { return in_parts_[static_cast<unsigned>(particle) / LinkBlocks::size] != 0; }
    int set_of(const LinkTable& links, int particle) const { return in_parts(particle) ? links.blocks().part_of(particle) : particle; }
    void unite_links_of(const subdivision::SubdivisionEngine& engine, const LinkTable& links, std::span<const int> particles);
    void unite_group(const subdivision::SubdivisionEngine& engine, const LinkTable& links, const ChildGroup& group, std::span<const int> members);

    UnionFind sets_;
    std::vector<Run> runs_;
    std::vector<std::uint8_t> in_parts_;  ///< per block: one that goes part by part
};

}  // namespace cleave::fragments
