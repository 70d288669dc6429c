#include "solver/subdivision/plain_subdivision.hpp"

#include "solver/mesh/check.hpp"
#include "solver/mesh/test/test_meshes.hpp"
#include "solver/subdivision/links.hpp"
#include "solver/subdivision/test/loose_tets.hpp"
#include "solver/subdivision/test/random.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace cleave::subdivision {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mesh::TetMesh;
using mesh::test::kuhn_cube;
using mesh::test::unit_tet;

/// The plane on which the affine function with these values at the tet's corners vanishes, '+' where it is positive.
Cut plane_with_values(const TetMesh& mesh, const std::array<double, 4>& values) {
    const auto& tet = mesh.tets[0];
    Matrix3d edges;
    Vector3d rises;
    for (int i = 0; i < 3; ++i) {
        edges.row(i) = (mesh.vertices[tet[i + 1]] - mesh.vertices[tet[0]]).transpose();
        rises[i] = values[i + 1] - values[0];
    }
    const Vector3d gradient = edges.inverse() * rises;
    return {.centre = mesh.vertices[tet[0]] - values[0] * gradient / gradient.squaredNorm(), .normal = gradient};
}

TEST(PlainSubdivision, AllSignPatternsInAllVertexOrders) {
    std::array<int, 4> order{0, 1, 2, 3};
    do {
        TetMesh mesh = unit_tet();
        for (int i = 0; i < 4; ++i) mesh.vertices[order[i]] = unit_tet().vertices[i];
        mesh.tets[0] = order;  // the same tet under other vertex numbers: sorted orders of both orientations
        for (unsigned mask = 0; mask < 16; ++mask) {
            std::array<double, 4> values{};
            for (int i = 0; i < 4; ++i) values[i] = (mask >> i & 1U) != 0 ? 1.0 + 0.1 * i : -1.5 - 0.2 * i;
            const int plus = std::popcount(mask);
            if (plus == 0 || plus == 4) continue;
            const Subdivided out = subdivide(mesh, {plane_with_values(mesh, values)});
            EXPECT_EQ(out.mesh.tets.size(), plus == 2 ? 20u : 14u);
            EXPECT_EQ(out.counts, (Counts{0, plus != 2, plus == 2}));
            mesh::check(out.mesh, "children");  // none inverted, none twice, no overlap
            const Audit found = audit(mesh, out);
            EXPECT_LE(found.volume_error, 1e-15);
            EXPECT_LE(found.stated_volume_error, 1e-15);
            EXPECT_EQ(found.unpaired + found.asymmetric + found.paired_boundary, 0);
            EXPECT_TRUE(out.extra_links.empty());
        }
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(PlainSubdivision, TwentyThousandRandomTetsAndPlanes) {  // 10^6 of them: million_tets_test.cpp
    test::Random random(2024);
    EXPECT_GT(test::cut_loose_tets(random, 80), 12'000);
}

TEST(PlainSubdivision, WithoutTheVertexRuleChildrenVanish) {
    test::Random random(3);
    double with_rule = 1, without = 1;
    const TetMesh mesh = kuhn_cube(4, 0.1);
    for (int round = 0; round < 20; ++round) {
        Cut cut = random.plane(0.2, 0.8);
        cut.centre = mesh.vertices[62] + 1e-6 * cut.normal;  // a hair off the vertex in the middle
        with_rule = std::min(with_rule, audit(mesh, subdivide(mesh, {cut})).smallest_share);
        without = std::min(without, audit(mesh, subdivide(mesh, {cut}, {.tau = 0})).smallest_share);
    }
    EXPECT_GE(with_rule, 3e-4);  // tau = 0.1 on meshes of ordinary shape
    EXPECT_LE(without, 1e-9);    // the twin: slivers without it
}

TEST(PlainSubdivision, SidesHaveTheVolumesOfTheHalfSpaces) {
    const TetMesh mesh = kuhn_cube(5, 0.15);
    const auto plus_volume = [&](const Cut& cut) {
        const Subdivided out = subdivide(mesh, {cut}, {.tau = 0});  // tau = 0: cut exactly along the plane
        double sum = 0;
        for (std::size_t tet = 0; tet < out.volume.size(); ++tet) {
            const bool plus = out.side[tet] > 0 || (out.side[tet] == 0 && cut.normal.dot(out.centroid[tet] - cut.centre) > 0);
            sum += plus ? out.volume[tet] : 0;
        }
        return sum;
    };
    EXPECT_NEAR(plus_volume({.centre = {0, 0, 0.3}, .normal = {0, 0, 1}}), 0.7, 1e-14);
    EXPECT_NEAR(plus_volume({.centre = {0.5, 0.5, 0.5}, .normal = {1, 2, -0.7}}), 0.5, 1e-14);
    EXPECT_NEAR(plus_volume({.centre = {0.25, 0.25, 0.25}, .normal = {-1, -1, -1}}), std::pow(0.75, 3) / 6, 1e-14);  // a corner
}

TEST(PlainSubdivision, CutPointsLieOnThePlaneWhereNoVertexIsNear) {
    const TetMesh mesh = kuhn_cube(3);
    const Subdivided out = subdivide(mesh, {{.centre = {0, 0, 0.5}, .normal = {0, 0, 1}}});
    ASSERT_GT(out.mesh.vertices.size(), mesh.vertices.size());
    // Each child's side is told by its vertices: all on its side of z = 0.5, up to rounding.
    for (std::size_t tet = 0; tet < out.side.size(); ++tet) {
        for (const int v : out.mesh.tets[tet]) {
            EXPECT_GE(out.side[tet] * (out.mesh.vertices[v][2] - 0.5), -1e-15);
        }
    }
}

/// Volume, first moments and second moments of a mesh, by exact formulas for tets.
struct Moments {
    double volume = 0;
    Vector3d first = Vector3d::Zero();
    Matrix3d second = Matrix3d::Zero();
};

Moments moments(const TetMesh& mesh) {
    Moments sum;
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) {
        const double volume = mesh::tet_volume(mesh, static_cast<int>(tet));
        Vector3d total = Vector3d::Zero();
        Matrix3d squares = Matrix3d::Zero();
        for (const int v : mesh.tets[tet]) {
            total += mesh.vertices[v];
            squares += mesh.vertices[v] * mesh.vertices[v].transpose();
        }
        sum.volume += volume;
        sum.first += volume * total / 4;
        sum.second += volume / 20 * (squares + total * total.transpose());
    }
    return sum;
}

TEST(PlainSubdivision, ConservesMassCentreAndInertia) {
    test::Random random(8);
    const TetMesh mesh = kuhn_cube(4, 0.2);
    const Subdivided out = subdivide(mesh, {random.plane(0, 1), random.plane(0, 1), random.disc(0, 1)});
    const Moments before = moments(mesh), after = moments(out.mesh);
    EXPECT_NEAR(after.volume, before.volume, 1e-13);
    EXPECT_LE((after.first - before.first).norm(), 1e-13);
    EXPECT_LE((after.second - before.second).norm(), 1e-13);
    for (std::size_t tet = 0; tet < out.volume.size(); ++tet) {
        // Not the same formulas: shares of the parent against corners (rounding of a unit cube's coordinates by areas of a face), sums in
        // another order.
        EXPECT_NEAR(out.volume[tet], mesh::tet_volume(out.mesh, static_cast<int>(tet)), 1e-16);
        EXPECT_LE((out.centroid[tet] - mesh::tet_centroid(out.mesh, static_cast<int>(tet))).norm(), 4e-16);
    }
}

TEST(PlainSubdivision, ChildrenInheritRegionsAndSurfaceTagsArePassedOn) {
    TetMesh mesh = kuhn_cube(3, 0.1);
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) mesh.regions[tet] = static_cast<int>(tet % 5);
    const mesh::HalfFaceLinks links = mesh::link_half_faces(mesh);
    for (int h = 0; h < static_cast<int>(links.opposite.size()); ++h) {
        if (links.opposite[h] < 0) mesh.surface.push_back({mesh::face_of(mesh.tets[h / 4], h % 4), 9});
    }
    std::swap(mesh.surface[0].vertices[1], mesh.surface[0].vertices[2]);  // one that looks inwards stays so
    test::Random random(4);
    const Subdivided out = subdivide(mesh, {random.plane(0.3, 0.7), random.plane(0.3, 0.7)});
    for (std::size_t tet = 0; tet < out.mesh.tets.size(); ++tet) EXPECT_EQ(out.mesh.regions[tet], out.parent[tet] % 5);
    std::size_t boundary = 0;
    for (std::size_t h = 0; h < out.parent_face.size(); ++h) {
        boundary += out.parent_face[h] >= 0 && links.opposite[4 * out.parent[h / 4] + out.parent_face[h]] < 0;
    }
    EXPECT_EQ(out.mesh.surface.size(), boundary);
    EXPECT_GT(boundary, mesh.surface.size());
    const auto vector_area = [](const TetMesh& m) {
        Vector3d sum = Vector3d::Zero();
        for (const mesh::SurfaceTriangle& t : m.surface) {
            const auto& [a, b, c] = t.vertices;
            sum += 0.5 * (m.vertices[b] - m.vertices[a]).cross(m.vertices[c] - m.vertices[a]);
        }
        return sum;
    };
    EXPECT_LE((vector_area(out.mesh) - vector_area(mesh)).norm(), 1e-13);  // orientation kept, the turned triangle included
}

TEST(PlainSubdivision, CutsEachParentOnce) {
    const TetMesh mesh = kuhn_cube(3);
    PlainSubdivision subdivision(mesh);
    const Cut cut{.centre = {0.5, 0.5, 0.51}, .normal = {0.2, 0.1, 1}};
    const Counts first = subdivision.cut(cut);
    EXPECT_GT(first.three_one + first.two_two, 0);
    const std::size_t vertices = subdivision.result().mesh.vertices.size();
    const Counts second = subdivision.cut(cut);
    EXPECT_EQ(second.three_one + second.two_two, 0);
    EXPECT_EQ(subdivision.result().mesh.vertices.size(), vertices);  // and makes no points for nothing
}

TEST(PlainSubdivision, CreatesEachPointOnce) {
    test::Random random(12);
    const TetMesh mesh = kuhn_cube(5, 0.1);
    std::vector<Cut> cuts;
    for (int i = 0; i < 6; ++i) cuts.push_back(random.plane(0.2, 0.8));
    const Subdivided out = subdivide(mesh, cuts);
    std::vector<std::array<double, 3>> points;
    for (const Vector3d& x : out.mesh.vertices) points.push_back({x[0], x[1], x[2]});
    std::sort(points.begin(), points.end());
    EXPECT_EQ(std::adjacent_find(points.begin(), points.end()), points.end());
}

TEST(PlainSubdivision, RepeatsToTheBit) {
    test::Random random(9);
    const std::vector<Cut> cuts{random.plane(0, 1), random.disc(0, 1), random.plane(0, 1)};
    const Subdivided a = subdivide(kuhn_cube(4, 0.1), cuts), b = subdivide(kuhn_cube(4, 0.1), cuts);
    EXPECT_EQ(a.mesh.tets, b.mesh.tets);
    EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
    EXPECT_EQ(a.links.opposite, b.links.opposite);
    EXPECT_EQ(a.extra_links, b.extra_links);
}

TEST(PlainSubdivision, FollowsTheDocumentedOrders) {
    test::Random random(10);
    const TetMesh mesh = kuhn_cube(3, 0.1);
    const Subdivided out = subdivide(mesh, {random.plane(0.3, 0.7), random.plane(0.3, 0.7)});
    for (std::size_t tet = 1; tet < out.parent.size(); ++tet) {
        EXPECT_LE(std::pair(out.cut[tet - 1], out.parent[tet - 1]), std::pair(out.cut[tet], out.parent[tet]));
    }
    std::vector<bool> used(out.mesh.vertices.size(), false);
    for (const auto& tet : out.mesh.tets) {
        for (const int v : tet) used[v] = true;
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);  // no point made that nobody uses
}

}  // namespace
}  // namespace cleave::subdivision
