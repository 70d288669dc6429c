#pragma once

#include "solver/fragments/fragmented_body.hpp"

#include <vector>

namespace cleave::fragments::test {

/// Particles that are linked (over a face, or over a part of one), first < second: read off the table of links.
std::vector<std::array<int, 2>> linked_pairs(const FragmentedBody& body);

/// Expects what must hold after any cracks: each particle in one current fragment, no link from one fragment to another, each
/// fragment connected (a flood over linked_pairs, not union-find), all volume there, all surfaces closed and enclosing their tets
/// (1e-12 of the body's volume: sums of some 1e5 terms of rounding 1e-16 relative to the body).
void expect_sound(const FragmentedBody& body);

/// Opens the crack in every fragment that stands now.
void crack_all(FragmentedBody& body, const Crack& crack);

}  // namespace cleave::fragments::test
