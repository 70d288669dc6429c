#pragma once

#include "solver/fragments/fragmented_body.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cleave::fragments {

/// Removes the links that a crack intersects, and those of the particles inside its inner radius.
class CrackOpening {
public:
    /// `disc` with a unit normal. `particles`: those of the fragment, subdivided already.
    CrackOpening(const FragmentedBody& body, const Crack& crack, const std::vector<int>& particles);

    /// Returns the number of links removed. In the adaptive scheme links of two whole tets are left: the disc touches neither.
    int remove_intersected(LinkTable& links) const;
    /// Returns the number of particles that lost all their links.
    int isolate_inside(LinkTable& links) const;

private:
    int side(int particle) const;
    bool intersects(int first, int second) const { return side(first) != side(second) && meets_disc(first, second); }
    bool breaks(int particle) const { return !crack_.region || body_.region(particle) == *crack_.region; }
    bool meets_disc(int first, int second) const;
    int open_new_parents(LinkTable& links) const;
    int open_faces(LinkTable& links, std::span<const int> particles) const;
    std::vector<int> particles_near(std::span<const int> particles, const std::vector<std::int8_t>& box_sides) const;
    void prefetch_near(const std::vector<int>& near, std::size_t i) const;
    int open_partial(LinkTable& links) const;
    bool is_ours(int particle) const { return body_.fragment_of(particle) == fragment_; }

    const FragmentedBody& body_;
    const subdivision::SubdivisionEngine& engine_;
    const Crack& crack_;
    const std::vector<int>& particles_;
    int fragment_;
};

}  // namespace cleave::fragments
