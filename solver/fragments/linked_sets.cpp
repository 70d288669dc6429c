#include "solver/fragments/linked_sets.hpp"

namespace cleave::fragments {
namespace {

using subdivision::SubdivisionEngine;
using Particles = std::span<const int>;

/// Whether a block starts with the first particle, all of it is among the particles, and no crack has touched it.
bool starts_block(const LinkTable& links, Particles particles) {
    constexpr int size = LinkBlocks::size;
    const int first = particles.front(), block = first / size;
    return first % size == 0 && block < links.blocks().blocks() && particles.size() >= size && particles[size - 1] == first + size - 1 &&
           links.is_untouched(block);
}

/// The group that starts with the first particle, if all of it is among the particles and has lost no link inside.
const ChildGroup* starts_group(const SubdivisionEngine& engine, const LinkTable& links, Particles particles) {
    const int first = particles.front(), child = first - links.originals();
    if (child < 0) return nullptr;
    const int parent = engine.child_parents()[static_cast<std::size_t>(child)];
    const ChildGroup& group = group_from(engine.pieces(parent), child - engine.first_child(parent));
    const auto count = static_cast<std::size_t>(group.count);
    if (count == 0 || particles.size() < count || particles[count - 1] != first + group.count - 1) return nullptr;
    return links.has_all(first, {group.inner.data(), count}) ? &group : nullptr;
}

}  // namespace

/// Splits the particles into blocks, groups, and those between them.
void LinkedSets::find_runs(const SubdivisionEngine& engine, const LinkTable& links, Particles particles) {
    runs_.clear();
    std::size_t start = 0, i = 0;  // start: of those that go one by one
    const auto add = [&](int count, int block, const ChildGroup* group) {
        if (start < i) runs_.push_back({static_cast<int>(start), static_cast<int>(i - start), -1, nullptr});
        runs_.push_back({static_cast<int>(i), count, block, group});
        start = i += static_cast<std::size_t>(count);
    };
    while (i < particles.size()) {
        const Particles rest = particles.subspan(i);
        if (starts_block(links, rest)) add(LinkBlocks::size, rest.front() / LinkBlocks::size, nullptr);
        else if (const ChildGroup* group = starts_group(engine, links, rest)) add(group->count, -1, group);
        else ++i;
    }
    if (start < i) runs_.push_back({static_cast<int>(start), static_cast<int>(i - start), -1, nullptr});
}

/// Calls in_block(block), in_group(group, members) and one_by_one(particles) for all runs, in ascending order.
template <class InBlock, class InGroup, class OneByOne>
void LinkedSets::for_runs(Particles particles, const InBlock& in_block, const InGroup& in_group, const OneByOne& one_by_one) const {
    for (const Run& run : runs_) {
        const Particles members = particles.subspan(static_cast<std::size_t>(run.first), static_cast<std::size_t>(run.count));
        if (run.block >= 0) in_block(run.block);
        else if (run.group != nullptr) in_group(*run.group, members);
        else one_by_one(members);
    }
}

void LinkedSets::prepare(const SubdivisionEngine& engine, const LinkTable& links, Particles particles) {
    const LinkBlocks& blocks = links.blocks();
    sets_.grow(links.particles());
    in_parts_.assign(static_cast<std::size_t>(links.particles() / LinkBlocks::size) + 1, 0);
    find_runs(engine, links, particles);
    for_runs(particles,
         [&](int block) {
             in_parts_[static_cast<std::size_t>(block)] = 1;
             for (const int part : blocks.parts(block)) sets_.make_single(part);
         },
         [&](const ChildGroup&, Particles members) {
             sets_.make_single(members.front());
             sets_.follow(members.front(), static_cast<int>(members.size()), members.front());
         },
         [&](Particles rest) {
             for (const int particle : rest) sets_.make_single(particle);
         });
    for_runs(particles,
         [&](int block) {
             for (const auto& [part, other] : blocks.links_down(block)) {
                 if (in_parts(other)) sets_.unite(part, other);
             }
         },
         [&](const ChildGroup& group, Particles members) { unite_group(engine, links, group, members); },
         [&](Particles rest) { unite_links_of(engine, links, rest); });
}

/// Links down, and those up to what does not go particle by particle and so may pass over them: blocks, groups.
void LinkedSets::unite_links_of(const SubdivisionEngine& engine, const LinkTable& links, Particles particles) {
    const int originals = links.originals();
    int root = -1;
    links.for_each_link(engine, particles, [&](int particle) { root = sets_.find(particle); },
                        [&](int particle, int neighbour) { return (neighbour < particle) | in_parts(neighbour) | (particle >= originals); },
                        [&](int, int neighbour) { root = sets_.unite_root(root, set_of(links, neighbour)); });
}

/// One link through each face of the parent (a face conforms as a whole or not at all); where that one is removed, all links of the group.
void LinkedSets::unite_group(const SubdivisionEngine& engine, const LinkTable& links, const ChildGroup& group, Particles members) {
    const int parents_first = 4 * (members.front() - group.first);
    int root = sets_.find(members.front());
    for (int k = 0; k < group.faces; ++k) {
        const int half_face = parents_first + group.face[static_cast<std::size_t>(k)], behind = links.opposite(engine, half_face);
        if (behind < 0) continue;
        if (links.is_removed(half_face)) {
            unite_links_of(engine, links, members);
            return;
        }
        if (behind < half_face) root = sets_.unite_root(root, behind / 4);
    }
}

void LinkedSets::flatten(const LinkTable& links, Particles particles) {
    const LinkBlocks& blocks = links.blocks();
    for_runs(particles,
         [&](int block) {
             for (const int part : blocks.parts(block)) sets_.flatten(part);
             const int first = block * LinkBlocks::size, last = first + LinkBlocks::size;
             if (blocks.parts(block).size() == 1) sets_.follow(first, LinkBlocks::size, first);
             else for (int tet = first; tet < last; ++tet) sets_.follow(tet, 1, blocks.part_of(tet));
         },
         [&](const ChildGroup&, Particles members) {
             sets_.flatten(members.front());
             sets_.follow(members.front(), static_cast<int>(members.size()), members.front());
         },
         [&](Particles rest) {
             for (const int particle : rest) sets_.flatten(particle);
         });
}

}  // namespace cleave::fragments
