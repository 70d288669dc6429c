#include "solver/fragments/fragmented_body.hpp"

#include "solver/fragments/mass_properties.hpp"
#include "solver/fragments/test/invariants.hpp"
#include "solver/mesh/test/test_meshes.hpp"
#include "solver/subdivision/test/random.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace cleave::fragments {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mesh::test::kuhn_cube;
using subdivision::test::Random;
using test::crack_all;
using test::expect_sound;

TEST(FragmentedBody, APlaneMakesTwoHalvesOfTheRightVolume) {
    // tau = 0: the cut lies on the plane, so the halves are those of the cube.
    FragmentedBody body(kuhn_cube(5, 0.15), Scheme::adaptive, {.tau = 0});
    const CrackOutcome outcome = body.crack({.disc = {.centre = {0, 0, 0.3}, .normal = {0, 0, 1}}}, 0);
    ASSERT_EQ(outcome.new_fragments, (std::vector<int>{1, 2}));
    EXPECT_TRUE(body.fragment(0).retired);
    EXPECT_EQ(body.current_fragments(), (std::vector<int>{1, 2}));
    std::vector<double> volumes;
    for (const int number : body.current_fragments()) {
        EXPECT_EQ(body.fragment(number).origin, 0);
        volumes.push_back(mass_properties(body, body.fragment(number), [](int) { return 1.0; }).volume);
    }
    EXPECT_NEAR(std::min(volumes[0], volumes[1]), 0.3, 1e-14);
    EXPECT_NEAR(std::max(volumes[0], volumes[1]), 0.7, 1e-14);
    expect_sound(body);
}

TEST(FragmentedBody, ADiscInsideLeavesOnePiece) {
    FragmentedBody body(kuhn_cube(6, 0.1));
    const CrackOutcome outcome = body.crack({.disc = {.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.4, 0.3}, .radius = 0.3}}, 0);
    EXPECT_GT(outcome.removed_links, 0);
    EXPECT_TRUE(outcome.new_fragments.empty());
    EXPECT_EQ(body.current_fragments(), std::vector<int>{0});
    expect_sound(body);
}

TEST(FragmentedBody, RandomCracksInBothSchemes) {
    Random random(41);
    for (int round = 0; round < 24; ++round) {
        FragmentedBody body(kuhn_cube(2 + round % 4, round % 3 == 0 ? 0 : 0.15), round % 4 == 3 ? Scheme::basic : Scheme::adaptive);
        for (int i = 0; i < 1 + round % 5; ++i) {
            const bool disc = (i + round) % 2 == 0;
            crack_all(body, {.disc = disc ? random.disc(0, 1) : random.plane(0, 1), .inner_radius = i % 3 == 2 ? 0.15 : 0});
        }
        expect_sound(body);
    }
}

TEST(FragmentedBody, PlanesThroughVerticesEdgesAndFaces) {
    for (const Vector3d& normal : {Vector3d(0, 0, 1), Vector3d(1, -1, 0), Vector3d(1, 1, 1), Vector3d(1, -2, 1)}) {
        for (const Scheme scheme : {Scheme::adaptive, Scheme::basic}) {
            FragmentedBody body(kuhn_cube(4), scheme);
            crack_all(body, {.disc = {.centre = {0.5, 0.5, 0.5}, .normal = normal}});
            EXPECT_EQ(body.current_fragments().size(), 2u);
            crack_all(body, {.disc = {.centre = {0.25, 0.5, 0.75}, .normal = {-1, 1, 1}}});
            expect_sound(body);
        }
    }
}

TEST(FragmentedBody, TheBasicSchemeRemovesExactlyTheIntersectedLinks) {
    Random random(42);
    const mesh::TetMesh mesh = kuhn_cube(5, 0.15);
    for (int round = 0; round < 6; ++round) {
        FragmentedBody body(mesh, Scheme::basic);
        const subdivision::Cut disc = round % 2 == 0 ? random.plane(0.2, 0.8) : random.disc(0.2, 0.8);
        const CrackOutcome outcome = body.crack({.disc = disc}, 0);
        EXPECT_EQ(body.particle_numbers(), static_cast<int>(mesh.tets.size()));  // nothing was subdivided
        int removed = 0;
        for (int h = 0; h < 4 * body.originals(); ++h) {
            const int behind = body.links().opposite(body.engine(), h);
            if (behind < h) continue;
            // The segment a + t (b - a) meets the plane at t = -d_a / (n . (b - a)).
            const Vector3d a = mesh::tet_centroid(mesh, h / 4), along = mesh::tet_centroid(mesh, behind / 4) - a;
            const double t = -disc.normal.dot(a - disc.centre) / disc.normal.dot(along);
            const bool meets = t >= 0 && t <= 1 && (a + t * along - disc.centre).norm() <= disc.radius;
            EXPECT_EQ(body.links().is_removed(h), meets);
            removed += meets;
        }
        EXPECT_EQ(outcome.removed_links, removed);
    }
}

TEST(LinkBlocks, KnowWhatHangsTogetherInABlock) {
    const FragmentedBody body(kuhn_cube(5, 0.1));  // numbered cell by cell, row by row: blocks of several parts among them
    const LinkBlocks& blocks = body.links().blocks();
    ASSERT_EQ(blocks.blocks(), 750 / LinkBlocks::size);
    std::size_t parts = 0;
    for (int block = 0; block < blocks.blocks(); ++block) {
        parts += blocks.parts(block).size();
        std::set<std::array<int, 2>> down;
        for (int tet = block * LinkBlocks::size; tet < (block + 1) * LinkBlocks::size; ++tet) {
            EXPECT_LE(blocks.part_of(tet), tet);
            EXPECT_EQ(blocks.part_of(blocks.part_of(tet)), blocks.part_of(tet));
            for (int face = 0; face < 4; ++face) {
                const int behind = body.links().opposite(body.engine(), 4 * tet + face);
                if (behind < 0 || behind / 4 / LinkBlocks::size > block) continue;
                if (behind / 4 / LinkBlocks::size == block) EXPECT_EQ(blocks.part_of(tet), blocks.part_of(behind / 4));
                else down.insert({blocks.part_of(tet), blocks.part_of(behind / 4)});
            }
        }
        const auto known = blocks.links_down(block);
        EXPECT_EQ(std::vector(known.begin(), known.end()), std::vector(down.begin(), down.end()));
    }
    EXPECT_GE(parts, static_cast<std::size_t>(blocks.blocks()));
}

TEST(FragmentedBody, InsideTheInnerRadiusParticlesAreAlone) {
    for (const Scheme scheme : {Scheme::adaptive, Scheme::basic}) {
        FragmentedBody body(kuhn_cube(5, 0.1), scheme);
        const Vector3d centre(0.5, 0.5, 0.9);
        const CrackOutcome outcome = body.crack({.disc = {.centre = centre, .normal = {1, 0.2, 0}, .radius = 0.6}, .inner_radius = 0.2}, 0);
        int alone = 0;
        for (int particle = 0; particle < body.particle_numbers(); ++particle) {
            if (!body.is_particle(particle) || !((body.centroid(particle) - centre).norm() < 0.2)) continue;
            EXPECT_EQ(body.fragment(body.fragment_of(particle)).particles, std::vector<int>{particle});
            ++alone;
        }
        EXPECT_GT(alone, 10);
        EXPECT_EQ(outcome.isolated, alone);
        expect_sound(body);
    }
}

TEST(FragmentedBody, PiecesStayApartFromWhatTheirParentWasApartFrom) {
    // First a crater of lone particles, then planes that subdivide the tets around it: no piece may be linked to the crater again.
    FragmentedBody body(kuhn_cube(5, 0.1));
    body.crack({.disc = {.centre = {0.5, 0.5, 0.9}, .normal = {1, 0.2, 0}, .radius = 0.2}, .inner_radius = 0.25}, 0);
    const std::vector<int> pieces = body.current_fragments();
    const auto larger = [&](int a, int b) { return body.fragment(a).particles.size() < body.fragment(b).particles.size(); };
    const int rest = *std::max_element(pieces.begin(), pieces.end(), larger);
    const int before = body.fragments();
    body.crack({.disc = {.centre = {0.5, 0.5, 0.75}, .normal = {0.1, 0.2, 1}}}, rest);
    EXPECT_GT(body.fragments(), before);
    expect_sound(body);  // a link across fragments would be seen there
    for (const auto& [link, removed] : body.links().partial()) {
        const int lone = body.fragment_of(link.first / 4) != body.fragment_of(link.second / 4);
        EXPECT_EQ(removed, lone || removed);
    }
}

TEST(FragmentedBody, ACrackStaysInItsFragment) {
    FragmentedBody body(kuhn_cube(4, 0.1));
    body.crack({.disc = {.centre = {0.5, 0.5, 0.5}, .normal = {0, 0, 1}}}, 0);
    ASSERT_EQ(body.fragments(), 3);
    const std::vector<int> other = body.fragment(2).particles;
    const CrackOutcome outcome = body.crack({.disc = {.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.1, 0}}}, 1);
    EXPECT_EQ(outcome.new_fragments, (std::vector<int>{3, 4}));
    EXPECT_EQ(body.fragment(2).particles, other);
    EXPECT_FALSE(body.fragment(2).retired);
    expect_sound(body);
}

TEST(FragmentedBody, PiecesOfTheMeshAreTheFirstFragments) {
    mesh::TetMesh mesh = kuhn_cube(2), second = kuhn_cube(2);
    const int vertices = static_cast<int>(mesh.vertices.size());
    for (const Vector3d& x : second.vertices) mesh.vertices.push_back(x + Vector3d(2, 0, 0));
    for (auto tet : second.tets) {
        for (int& v : tet) v += vertices;
        mesh.tets.push_back(tet);
        mesh.regions.push_back(1);
    }
    const FragmentedBody body(mesh);
    EXPECT_EQ(body.current_fragments(), (std::vector<int>{0, 1}));
    EXPECT_EQ(body.fragment(1).particles.front(), 48);
    EXPECT_EQ(body.fragment(0).origin, -1);
    expect_sound(body);
}

TEST(FragmentedBody, MassCentreAndInertiaAreConserved) {
    Random random(43);
    mesh::TetMesh mesh = kuhn_cube(4, 0.2);
    const auto density = [](int tet) { return tet % 2 == 0 ? 1000.0 : 2500.0; };
    FragmentedBody body(mesh);
    const MassProperties before = mass_properties(body, body.fragment(0), density);
    for (int i = 0; i < 4; ++i) crack_all(body, {.disc = i % 2 == 0 ? random.plane(0, 1) : random.disc(0, 1), .inner_radius = 0.05});
    double mass = 0;
    Vector3d moment = Vector3d::Zero();
    Matrix3d inertia = Matrix3d::Zero();
    for (const int number : body.current_fragments()) {
        const MassProperties part = mass_properties(body, body.fragment(number), density);
        const Vector3d arm = part.centre - before.centre;
        mass += part.mass;
        moment += part.mass * part.centre;
        inertia += part.inertia + part.mass * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());  // Steiner
    }
    EXPECT_GT(body.current_fragments().size(), 4u);
    EXPECT_NEAR(mass, before.mass, 1e-12 * before.mass);
    EXPECT_LE((moment / mass - before.centre).norm(), 1e-12);
    EXPECT_LE((inertia - before.inertia).norm(), 1e-12 * before.inertia.norm());
}

TEST(MassProperties, OfACubeAreTheKnownOnes) {
    FragmentedBody body(kuhn_cube(3));
    const MassProperties cube = mass_properties(body, body.fragment(0), [](int) { return 6.0; });
    EXPECT_NEAR(cube.mass, 6, 1e-13);
    EXPECT_LE((cube.centre - Vector3d(0.5, 0.5, 0.5)).norm(), 1e-14);
    EXPECT_LE((cube.inertia - Matrix3d::Identity()).norm(), 1e-13);  // m s^2 / 6
}

TEST(FragmentedBody, ChildrenInherit) {
    mesh::TetMesh mesh = kuhn_cube(3, 0.1);
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) mesh.regions[tet] = static_cast<int>(tet % 3);
    FragmentedBody body(mesh);
    body.crack({.disc = {.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.4, 0.3}}}, 0);
    std::vector<Vector3d> velocity;
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) velocity.emplace_back(tet, 1, 2);
    std::size_t children = 0;
    for (const int number : body.current_fragments()) {
        const Fragment& fragment = body.fragment(number);
        const std::vector<Vector3d> values = inherited(body, fragment, velocity);
        for (std::size_t i = 0; i < fragment.particles.size(); ++i) {
            const int particle = fragment.particles[i];
            EXPECT_EQ(values[i], velocity[body.parent(particle)]);
            EXPECT_EQ(body.region(particle), body.parent(particle) % 3);
            children += particle >= body.originals();
        }
    }
    EXPECT_GT(children, 100u);
}

TEST(FragmentedBody, ACrackOfOneRegionStopsAtTheOther) {
    mesh::TetMesh mesh = kuhn_cube(4, 0.1);
    for (int tet = 0; tet < static_cast<int>(mesh.tets.size()); ++tet) mesh.regions[tet] = mesh::tet_centroid(mesh, tet)[0] < 0.5 ? 1 : 2;
    FragmentedBody body(mesh);
    const CrackOutcome outcome = body.crack({.disc = {.centre = {0.5, 0.5, 0.5}, .normal = {0.1, 0.1, 1}}, .region = 1}, 0);
    EXPECT_GT(outcome.removed_links, 10);
    EXPECT_TRUE(outcome.new_fragments.empty());  // region 2 holds the halves together
    for (const int parent : body.engine().last_parents()) EXPECT_EQ(mesh.regions[parent], 1);
    for (int particle = 0; particle < body.particle_numbers(); ++particle) {
        for (int face = 0; face < 4 && body.is_particle(particle); ++face) {
            EXPECT_TRUE(!body.links().is_removed(4 * particle + face) || body.region(particle) == 1);
        }
    }
    expect_sound(body);
}

TEST(FragmentedBody, IsWholeAgainAfterReset) {
    const Crack first{.disc = {.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.4, 0.3}}, .inner_radius = 0.1};
    FragmentedBody body(kuhn_cube(4, 0.1));
    const CrackOutcome once = body.crack(first, 0);
    body.reset();
    EXPECT_EQ(body.current_fragments(), std::vector<int>{0});
    expect_sound(body);
    const CrackOutcome again = body.crack(first, 0);
    EXPECT_EQ(again.removed_links, once.removed_links);
    EXPECT_EQ(again.new_fragments, once.new_fragments);
    expect_sound(body);
}

TEST(FragmentedBody, RefusesNonsense) {
    FragmentedBody body(kuhn_cube(2));
    EXPECT_THROW(body.crack({.disc = {.normal = Vector3d::Zero()}}, 0), std::invalid_argument);
    EXPECT_THROW(body.crack({.disc = {}, .inner_radius = -1}, 0), std::invalid_argument);
    EXPECT_THROW(body.crack({.disc = {}, .inner_radius = std::numeric_limits<double>::infinity()}, 0), std::invalid_argument);
    EXPECT_THROW(body.crack({.disc = {}}, 1), std::invalid_argument);
    EXPECT_THROW(body.crack({.disc = {}}, -1), std::invalid_argument);
    body.crack({.disc = {.centre = {0.5, 0.5, 0.5}, .normal = {0, 0, 1}}}, 0);
    EXPECT_THROW(body.crack({.disc = {}}, 0), std::invalid_argument);  // fell apart
    expect_sound(body);
}

}  // namespace
}  // namespace cleave::fragments
