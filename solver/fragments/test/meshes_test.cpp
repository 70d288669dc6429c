#include "solver/mesh/recipes/pot.hpp"

#include "solver/fragments/test/invariants.hpp"
#include "solver/subdivision/test/random.hpp"

#include <gtest/gtest.h>

namespace cleave::fragments {
namespace {

TEST(FragmentsOfThePot, ManyCracksLeaveClosedSurfaces) {
    const mesh::TetMesh mesh = mesh::pot(1500).mesh;
    for (const Scheme scheme : {Scheme::adaptive, Scheme::basic}) {
        for (const int count : {1, 8, 50}) {
            subdivision::test::Random random(static_cast<std::uint64_t>(count));
            FragmentedBody body(mesh, scheme);
            for (int i = 0; i < count; ++i) {
                subdivision::Cut cut = i % 2 == 0 ? random.plane(-0.12, 0.12) : random.disc(-0.12, 0.12);
                cut.centre[2] += 0.12;
                const std::vector<int> current = body.current_fragments();  // cracks come one by one, each in one fragment
                body.crack({.disc = cut, .inner_radius = i % 5 == 4 ? 0.02 : 0}, current[static_cast<std::size_t>(i) % current.size()]);
                if (i == 0) test::crack_all(body, {.disc = cut});
            }
            test::expect_sound(body);
        }
    }
}

}  // namespace
}  // namespace cleave::fragments
