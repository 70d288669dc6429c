#include "solver/subdivision/links.hpp"

#include "solver/mesh/test/test_meshes.hpp"
#include "solver/subdivision/plain_subdivision.hpp"
#include "solver/subdivision/test/random.hpp"
#include "solver/subdivision/test/sound.hpp"
#include "solver/subdivision/triangle_overlap.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace cleave::subdivision {
namespace {

using Eigen::Vector3d;
using mesh::TetMesh;
using mesh::test::kuhn_cube;
using test::expect_sound;

TEST(Links, StructuredMeshesCutByPlanesAndDiscs) {
    test::Random random(21);
    for (int round = 0; round < 40; ++round) {
        const TetMesh mesh = kuhn_cube(2 + round % 4, round % 3 == 0 ? 0 : 0.15);
        std::vector<Cut> cuts;
        for (int i = 0; i < 1 + round % 7; ++i) cuts.push_back(i % 2 == 0 ? random.plane(0, 1) : random.disc(0, 1));
        expect_sound(mesh, subdivide(mesh, cuts));
    }
}

TEST(Links, FiftyCuts) {
    test::Random random(22);
    const TetMesh mesh = kuhn_cube(6, 0.15);
    std::vector<Cut> cuts;
    for (int i = 0; i < 50; ++i) cuts.push_back(i % 2 == 0 ? random.plane(0, 1) : random.disc(0, 1));
    expect_sound(mesh, subdivide(mesh, cuts));
}

TEST(Links, PlanesThroughVerticesEdgesAndFaces) {
    const TetMesh mesh = kuhn_cube(4);
    const Vector3d middle(0.5, 0.5, 0.5);
    for (const Vector3d& normal : {Vector3d(0, 0, 1), Vector3d(0, 0, -1), Vector3d(1, -1, 0), Vector3d(1, 1, 1), Vector3d(1, 1, 0),
                                   Vector3d(1, -2, 1), Vector3d(2, 1, -1)}) {
        for (const Vector3d& centre : {middle, Vector3d(0, 0, 0), Vector3d(1, 1, 1), Vector3d(0.25, 0.5, 0.75)}) {
            expect_sound(mesh, subdivide(mesh, {{.centre = centre, .normal = normal}}));
        }
    }
    // A plane that holds the bottom: all of it is '+', nothing is cut; from the other side the lowest layer is.
    EXPECT_EQ(subdivide(mesh, {{.centre = {0, 0, 0}, .normal = {0, 0, 1}}}).counts.uncut, 384);
    EXPECT_LT(subdivide(mesh, {{.centre = {0, 0, 0}, .normal = {0, 0, -1}}}).counts.uncut, 384);
}

/// (triangles on one side, on the other; fewer first) -> link counts seen, over the non-conforming original faces.
std::map<std::pair<int, int>, std::multiset<int>> link_counts(const TetMesh& mesh, const Subdivided& out) {
    const mesh::HalfFaceLinks original = mesh::link_half_faces(mesh);
    std::map<int, int> links;
    std::map<int, std::set<int>> low, high;
    for (const ExtraLink& link : out.extra_links) {
        for (const int h : {link.first, link.second}) {
            const int here = 4 * out.parent[h / 4] + out.parent_face[h];
            (here < original.opposite[here] ? low : high)[std::min(here, original.opposite[here])].insert(h);
            if (h == link.first) ++links[std::min(here, original.opposite[here])];
        }
    }
    std::map<std::pair<int, int>, std::multiset<int>> counts;
    for (const auto& [face, count] : links) {
        const int a = static_cast<int>(low[face].size()), b = static_cast<int>(high[face].size());
        counts[{std::min(a, b), std::max(a, b)}].insert(count);
    }
    return counts;
}

TEST(Links, OnePlaneGivesOneToThreeOnlyInThirds) {
    const TetMesh mesh = kuhn_cube(6, 0.1);
    const Subdivided out = subdivide(mesh, {{.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.4, 0.3}}});
    const auto counts = link_counts(mesh, out);
    ASSERT_EQ(counts.size(), 1u);
    EXPECT_EQ(counts.begin()->first, std::pair(1, 3));
    EXPECT_EQ(counts.begin()->second.count(3), counts.begin()->second.size());
    for (const ExtraLink& link : out.extra_links) {
        const int whole = out.side[link.first / 4] == 0 ? link.first : link.second;
        const auto [a, b, c] = mesh::face_of(out.mesh.tets[whole / 4], whole % 4);
        const double area = triangle_area({out.mesh.vertices[a], out.mesh.vertices[b], out.mesh.vertices[c]});
        EXPECT_NEAR(link.area, area / 3, 1e-14 * area);  // a barycentre divides its triangle into thirds
    }
    // Not rare (physics): about one per 3-1 tet, less those whose base lies on the boundary or meets another base.
    EXPECT_GT(out.extra_links.size(), static_cast<std::size_t>(out.counts.three_one));
}

TEST(Links, DiscsAndLaterPlanesGiveAllFourKinds) {
    test::Random random(23);
    const TetMesh mesh = kuhn_cube(6, 0.15);
    std::map<std::pair<int, int>, std::multiset<int>> all;
    for (int round = 0; round < 12; ++round) {
        const std::vector<Cut> cuts{random.disc(0.2, 0.8), random.plane(0.2, 0.8), random.plane(0.2, 0.8)};
        for (auto& [kind, counts] : link_counts(mesh, subdivide(mesh, cuts))) {
            all[kind].merge(counts);
        }
    }
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all.at({1, 3}).count(3), all.at({1, 3}).size());
    EXPECT_EQ(all.at({1, 5}).count(5), all.at({1, 5}).size());
    // 3-5: the five (one triangle, four of a quadrilateral) meet the three in 10 pairs, or 11 where an edge crosses one more.
    EXPECT_EQ(*all.at({3, 5}).begin(), 10);
    EXPECT_EQ(*all.at({3, 5}).rbegin(), 11);
    EXPECT_GE(*all.at({5, 5}).begin(), 5);
    EXPECT_LE(*all.at({5, 5}).rbegin(), 25);
}

/// All overlapping pairs of half faces by brute force: opposite normals, one plane, a common area.
std::map<std::pair<int, int>, double> overlaps_by_brute_force(const TetMesh& mesh) {
    std::vector<Triangle> faces;
    std::vector<Vector3d> normals;
    for (int h = 0; h < static_cast<int>(4 * mesh.tets.size()); ++h) {
        const auto [a, b, c] = mesh::face_of(mesh.tets[h / 4], h % 4);
        faces.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
        normals.push_back((faces.back()[1] - faces.back()[0]).cross(faces.back()[2] - faces.back()[0]).normalized());
    }
    std::map<std::pair<int, int>, double> found;
    for (int g = 0; g < static_cast<int>(faces.size()); ++g) {
        const FaceFrame frame(faces[g]);
        for (int h = g + 1; h < static_cast<int>(faces.size()); ++h) {
            if (normals[g].dot(normals[h]) > -1 + 1e-9 || std::abs(normals[g].dot(faces[h][0] - faces[g][0])) > 1e-9) continue;
            const double area = overlap_area(frame.flat(faces[g]), frame.flat(faces[h]));
            if (area > 1e-12) found[{g, h}] = area;
        }
    }
    return found;
}

TEST(Links, AgreeWithBruteForce) {
    test::Random random(24);
    for (int round = 0; round < 4; ++round) {
        const TetMesh mesh = kuhn_cube(2, 0.15);
        const Subdivided out = subdivide(mesh, {random.disc(0.3, 0.7), random.plane(0.3, 0.7), random.plane(0.3, 0.7)});
        std::map<std::pair<int, int>, double> linked;
        for (const ExtraLink& link : out.extra_links) linked[{link.first, link.second}] = link.area;
        for (int h = 0; h < static_cast<int>(out.links.opposite.size()); ++h) {
            const int other = out.links.opposite[h];
            if (other <= h) continue;
            const auto [a, b, c] = mesh::face_of(out.mesh.tets[h / 4], h % 4);
            linked[{h, other}] = triangle_area({out.mesh.vertices[a], out.mesh.vertices[b], out.mesh.vertices[c]});
        }
        const auto expected = overlaps_by_brute_force(out.mesh);
        ASSERT_EQ(linked.size(), expected.size());
        for (const auto& [pair, area] : expected) {
            ASSERT_TRUE(linked.contains(pair));
            EXPECT_NEAR(linked.at(pair), area, 1e-13);
        }
    }
}

class AuditFinds : public testing::Test {
protected:
    TetMesh mesh_ = kuhn_cube(3, 0.1);
    Subdivided out_ = subdivide(mesh_, {{.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.4, 0.3}}});
};

TEST_F(AuditFinds, NothingInSoundWork) { expect_sound(mesh_, out_); }

TEST_F(AuditFinds, ALinkThatPointsElsewhere) {
    std::vector<int>& opposite = out_.links.opposite;
    const auto first = std::find_if(opposite.begin(), opposite.end(), [](int other) { return other >= 0; });
    *first = *std::find_if(first + 1, opposite.end(), [&](int other) { return other >= 0 && other != *first; });
    EXPECT_GT(audit(mesh_, out_).asymmetric, 0);
}

TEST_F(AuditFinds, AMissingLink) {
    std::vector<int>& opposite = out_.links.opposite;
    const int other = *std::find_if(opposite.begin(), opposite.end(), [](int h) { return h >= 0; });
    opposite[opposite[other]] = -1;
    opposite[other] = -1;
    EXPECT_EQ(audit(mesh_, out_).unpaired, 2);
}

TEST_F(AuditFinds, AMissingExtraLink) {
    out_.extra_links.pop_back();
    EXPECT_GT(audit(mesh_, out_).worst_area_error, 0.3);
}

TEST_F(AuditFinds, AVertexOutOfPlace) {
    out_.mesh.vertices[mesh_.vertices.size()] += Vector3d(0.01, 0.02, 0.03);  // the first cut point, off its edge
    EXPECT_GT(audit(mesh_, out_).volume_error, 1e-6);
}

TEST_F(AuditFinds, AMissingChild) {
    Subdivided fewer = out_;
    fewer.mesh.tets.pop_back();
    fewer.parent.pop_back();
    for (int face = 0; face < 4; ++face) fewer.parent_face.pop_back();
    find_links(mesh_, fewer);
    const Audit found = audit(mesh_, fewer);
    EXPECT_GT(found.volume_error, 1e-6);
    EXPECT_GT(found.unpaired, 0);
}

}  // namespace
}  // namespace cleave::subdivision
