#include "solver/fragments/test/invariants.hpp"

#include "solver/fragments/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace cleave::fragments::test {

std::vector<std::array<int, 2>> linked_pairs(const FragmentedBody& body) {
    std::vector<std::array<int, 2>> pairs;
    const LinkTable& links = body.links();
    for (int particle = 0; particle < body.particle_numbers(); ++particle) {
        for (int face = 0; face < 4 && body.is_particle(particle); ++face) {
            const int behind = links.opposite(body.engine(), 4 * particle + face);
            if (behind / 4 <= particle || !body.is_particle(behind / 4)) continue;
            EXPECT_EQ(links.is_removed(4 * particle + face), links.is_removed(behind));
            if (!links.is_removed(behind)) pairs.push_back({particle, behind / 4});
        }
    }
    for (const auto& [link, removed] : links.partial()) {
        if (!removed) pairs.push_back({std::min(link.first, link.second) / 4, std::max(link.first, link.second) / 4});
    }
    return pairs;
}

namespace {

std::size_t flooded(const std::map<int, std::vector<int>>& neighbours, int start) {
    std::set<int> seen{start};
    std::vector<int> waiting{start};
    while (!waiting.empty()) {
        const int here = waiting.back();
        waiting.pop_back();
        const auto at = neighbours.find(here);
        if (at == neighbours.end()) continue;
        for (const int next : at->second) {
            if (seen.insert(next).second) waiting.push_back(next);
        }
    }
    return seen.size();
}

void expect_connected(const FragmentedBody& body) {
    std::map<int, std::vector<int>> neighbours;
    for (const auto& [a, b] : linked_pairs(body)) {
        EXPECT_EQ(body.fragment_of(a), body.fragment_of(b));
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    }
    for (const int number : body.current_fragments()) {
        const Fragment& fragment = body.fragment(number);
        EXPECT_EQ(flooded(neighbours, fragment.particles.at(0)), fragment.particles.size());
    }
}

void expect_partition(const FragmentedBody& body) {
    std::set<int> seen;
    for (const int number : body.current_fragments()) {
        for (const int particle : body.fragment(number).particles) {
            EXPECT_TRUE(body.is_particle(particle));
            EXPECT_EQ(body.fragment_of(particle), number);
            EXPECT_TRUE(seen.insert(particle).second);
        }
    }
    std::size_t particles = 0;
    for (int i = 0; i < body.particle_numbers(); ++i) particles += body.is_particle(i);
    EXPECT_EQ(seen.size(), particles);
}

}  // namespace

void expect_sound(const FragmentedBody& body) {
    expect_partition(body);
    expect_connected(body);
    const double whole = mesh::total_volume(body.original());
    double sum = 0;
    for (const int number : body.current_fragments()) {
        const Fragment& fragment = body.fragment(number);
        double volume = 0;
        for (const int particle : fragment.particles) volume += body.volume(particle);
        const Surface skin = surface(body, fragment);
        EXPECT_EQ(open_edges(skin), 0) << "fragment " << number << " of " << fragment.particles.size() << " particles";
        EXPECT_NEAR(enclosed_volume(skin), volume, 1e-12 * whole);
        sum += enclosed_volume(skin);
    }
    EXPECT_NEAR(sum, whole, 1e-12 * whole);
}

void crack_all(FragmentedBody& body, const Crack& crack) {
    for (const int number : body.current_fragments()) body.crack(crack, number);
}

}  // namespace cleave::fragments::test
