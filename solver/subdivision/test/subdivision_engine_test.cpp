#include "solver/subdivision/subdivision_engine.hpp"

#include "solver/mesh/test/test_meshes.hpp"
#include "solver/subdivision/plain_subdivision.hpp"
#include "solver/subdivision/test/engine_equals.hpp"
#include "solver/subdivision/test/random.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace cleave::subdivision {
namespace {

using Eigen::Vector3d;
using mesh::TetMesh;
using mesh::test::kuhn_cube;
using test::first_difference;

Subdivided by_engine(const TetMesh& mesh, const std::vector<Cut>& cuts, const Options& options = {}) {
    SubdivisionEngine engine(mesh, options);
    for (const Cut& cut : cuts) engine.cut(cut);
    return engine.result();
}

/// The mesh with vertices and tets in another order, and each tet's corners turned: sorted orders of both orientations.
TetMesh shuffled(const TetMesh& mesh, test::Random& random) {
    const auto permutation = [&](std::size_t size) {
        std::vector<int> order(size);
        std::iota(order.begin(), order.end(), 0);
        for (std::size_t i = size; i > 1; --i) {
            std::swap(order[i - 1], order[static_cast<std::size_t>(random.uniform(0, static_cast<double>(i)))]);
        }
        return order;
    };
    TetMesh out = mesh;
    const std::vector<int> vertices = permutation(mesh.vertices.size()), tets = permutation(mesh.tets.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) out.vertices[vertices[v]] = mesh.vertices[v];
    for (std::size_t t = 0; t < tets.size(); ++t) {
        auto tet = mesh.tets[tets[t]];
        for (int& v : tet) v = vertices[v];
        std::rotate(tet.begin(), tet.begin() + 1 + static_cast<int>(t % 2), tet.end() - 1 + static_cast<int>(t % 2));
        out.tets[t] = tet;
        if (mesh::tet_volume(out, static_cast<int>(t)) < 0) std::swap(out.tets[t][0], out.tets[t][3]);
        out.regions[t] = mesh.regions[tets[t]];
    }
    return out;
}

TEST(SubdivisionEngine, EqualsThePlainFormToTheBit) {
    test::Random random(31);
    for (int round = 0; round < 60; ++round) {
        const TetMesh mesh = shuffled(kuhn_cube(2 + round % 5, round % 3 == 0 ? 0 : 0.15), random);
        std::vector<Cut> cuts;
        for (int i = 0; i < 1 + round % 9; ++i) cuts.push_back((i + round) % 2 == 0 ? random.plane(0, 1) : random.disc(0, 1));
        const Options options{.tau = round % 4 == 0 ? 0 : 0.1, .streamed_from = round % 2 == 0 ? 0 : 1 << 20};
        ASSERT_EQ(first_difference(by_engine(mesh, cuts, options), subdivide(mesh, cuts, options)), "") << "round " << round;
    }
}

TEST(SubdivisionEngine, EqualsThePlainFormAfterFiftyCuts) {
    test::Random random(32);
    const TetMesh mesh = shuffled(kuhn_cube(6, 0.15), random);
    std::vector<Cut> cuts;
    for (int i = 0; i < 50; ++i) cuts.push_back(i % 2 == 0 ? random.plane(0, 1) : random.disc(0, 1));
    for (const int streamed_from : {0, 1 << 20}) {
        EXPECT_EQ(first_difference(by_engine(mesh, cuts, {.streamed_from = streamed_from}), subdivide(mesh, cuts)), "") << streamed_from;
    }
}

TEST(SubdivisionEngine, EqualsThePlainFormOnPlanesThroughVertices) {
    const TetMesh mesh = kuhn_cube(4);
    for (const Vector3d& normal : {Vector3d(0, 0, 1), Vector3d(0, 0, -1), Vector3d(1, -1, 0), Vector3d(1, 1, 1), Vector3d(1, -2, 1)}) {
        const std::vector<Cut> cuts{{.centre = {0.5, 0.5, 0.5}, .normal = normal}, {.centre = {0.25, 0.5, 0.75}, .normal = {-1, 1, 1}}};
        EXPECT_EQ(first_difference(by_engine(mesh, cuts), subdivide(mesh, cuts)), "");
    }
}

TEST(SubdivisionEngine, EqualsThePlainFormInALargeBody) {
    // Above 20,000 tets the engine searches boxes along a Morton curve instead of scanning.
    test::Random random(35);
    const TetMesh mesh = shuffled(kuhn_cube(15, 0.1), random);
    ASSERT_GE(mesh.tets.size(), 20000u);
    std::vector<Cut> cuts;
    for (int i = 0; i < 4; ++i) cuts.push_back(i % 2 == 0 ? random.plane(0.1, 0.9) : random.disc(0.1, 0.9));
    cuts.push_back({.centre = {1.0 / 3, 0.5, 0.5}, .normal = {1, 0, 0}});  // through a layer of vertices
    EXPECT_EQ(first_difference(by_engine(mesh, cuts), subdivide(mesh, cuts)), "");
}

TEST(SubdivisionEngine, GivesTheSameBytesForAnyNumberOfThreads) {
    const tbb::global_control allow_more_than_processors(tbb::global_control::max_allowed_parallelism, 8);
    test::Random random(36);
    for (const int cells : {12, 24}) {  // scanned, and searched by boxes
        const TetMesh mesh = shuffled(kuhn_cube(cells, 0.1), random);
        std::vector<Cut> cuts{{.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.4, 0.3}}, random.disc(0.3, 0.7), random.plane(0.3, 0.7)};
        const Subdivided plain = subdivide(mesh, cuts);
        ASSERT_GT(plain.counts.three_one + plain.counts.two_two, cells == 24 ? 4096 : 1000);  // far above what one thread does alone
        for (const int threads : {1, 2, 4, 8}) {
            for (const int streamed_from : {0, 1 << 20}) {
                const Options options{.tau = 0.1, .threads = threads, .streamed_from = streamed_from};
                EXPECT_EQ(first_difference(by_engine(mesh, cuts, options), plain), "") << threads << " threads, streamed from " << streamed_from;
            }
        }
    }
}

TEST(SubdivisionEngine, CutsOnlyAmongTheTetsItIsGiven) {
    const TetMesh mesh = kuhn_cube(4, 0.1);
    std::vector<int> label;
    for (int tet = 0; tet < static_cast<int>(mesh.tets.size()); ++tet) label.push_back(mesh::tet_centroid(mesh, tet)[1] < 0.5);
    SubdivisionEngine engine(mesh), all(mesh);
    const Cut cut{.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.1, 0.2}};
    engine.cut(cut, {label.data(), 1});
    all.cut(cut);
    int both = 0;
    for (int tet = 0; tet < engine.originals(); ++tet) {
        EXPECT_EQ(engine.is_cut(tet), all.is_cut(tet) && label[tet] == 1);
        both += engine.is_cut(tet);
    }
    EXPECT_GT(both, 20);
}

TEST(SubdivisionEngine, PassesOnSurfaceTagsAndRegions) {
    test::Random random(33);
    TetMesh mesh = kuhn_cube(3, 0.1);
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) mesh.regions[tet] = static_cast<int>(tet % 3);
    for (int tet = 0; tet < 40; ++tet) mesh.surface.push_back({mesh::face_of(mesh.tets[tet], tet % 4), tet});
    const std::vector<Cut> cuts{random.plane(0.2, 0.8), random.plane(0.2, 0.8)};
    EXPECT_EQ(first_difference(by_engine(mesh, cuts), subdivide(mesh, cuts)), "");
}

TEST(SubdivisionEngine, IsWholeAgainAfterReset) {
    test::Random random(34);
    const TetMesh mesh = kuhn_cube(4, 0.1);
    SubdivisionEngine engine(mesh);
    const std::string whole = first_difference(engine.result(), subdivide(mesh, {}));
    EXPECT_EQ(whole, "");
    for (int round = 0; round < 5; ++round) {
        const std::vector<Cut> cuts{random.plane(0, 1), random.disc(0, 1), random.plane(0, 1)};
        for (const Cut& cut : cuts) engine.cut(cut);
        EXPECT_EQ(first_difference(engine.result(), subdivide(mesh, cuts)), "");
        engine.reset();
        EXPECT_EQ(first_difference(engine.result(), subdivide(mesh, {})), "");
    }
}

TEST(SubdivisionEngine, RefusesNonsense) {
    SubdivisionEngine engine(kuhn_cube(1));
    EXPECT_THROW(engine.cut({.normal = Vector3d::Zero()}), std::invalid_argument);
    EXPECT_THROW(engine.cut({.radius = -1}), std::invalid_argument);
    EXPECT_THROW(SubdivisionEngine(kuhn_cube(1), {.tau = 0.7}), std::invalid_argument);
    EXPECT_EQ(engine.counts(), (Counts{6, 0, 0}));
}

TEST(FirstDifference, SeesASingleBit) {
    const TetMesh mesh = kuhn_cube(3, 0.1);
    const std::vector<Cut> cuts{{.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.4, 0.3}}};
    const Subdivided sound = subdivide(mesh, cuts);
    Subdivided other = sound;
    other.volume.back() = std::nextafter(other.volume.back(), 1.0);
    EXPECT_EQ(first_difference(sound, other), "volume");
    other = sound;
    other.extra_links.back().area = std::nextafter(other.extra_links.back().area, 1.0);
    EXPECT_EQ(first_difference(sound, other), "extra_links");
    other = sound;
    std::swap(other.links.opposite[0], other.links.opposite[1]);
    EXPECT_EQ(first_difference(sound, other), "links");
}

}  // namespace
}  // namespace cleave::subdivision
