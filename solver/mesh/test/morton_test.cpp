#include "solver/mesh/morton.hpp"

#include "solver/mesh/check.hpp"
#include "solver/mesh/test/test_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace cleave::mesh {
namespace {

TEST(Morton, VisitsTheOctantsInOrder) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 7; i >= 0; --i) points.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
    EXPECT_EQ(morton_order(points), (std::vector<int>{7, 6, 5, 4, 3, 2, 1, 0}));
    EXPECT_EQ(morton_order({{1, 1, 1}, {1, 1, 1}}), (std::vector<int>{0, 1}));  // a box without width
    EXPECT_TRUE(morton_order({}).empty());
}

TEST(Morton, TheCoarseOrderAgreesWithTheFineOne) {
    const TetMesh mesh = test::kuhn_cube(7, 0.2);
    EXPECT_EQ(coarse_morton_order(mesh.vertices), morton_order(mesh.vertices));  // no two vertices as near as 2^-10 of the box
    const std::vector<Eigen::Vector3d> close{{0, 0, 0}, {3e-4, 0, 0}, {1e-4, 0, 0}, {1, 1, 1}};
    EXPECT_EQ(morton_order(close), (std::vector<int>{0, 2, 1, 3}));
    EXPECT_EQ(coarse_morton_order(close), (std::vector<int>{0, 1, 2, 3}));  // one place on the curve: by number
    EXPECT_TRUE(coarse_morton_order({}).empty());
}

TEST(Morton, KeepsTheBody) {
    TetMesh mesh = test::kuhn_cube(4, 0.1);
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) mesh.regions[tet] = tet_centroid(mesh, static_cast<int>(tet))[0] < 0.5 ? 3 : 4;
    mesh.surface = {{face_of(mesh.tets[5], 2), 8}};
    const TetMesh out = in_morton_order(mesh);
    check(out, "reordered");
    EXPECT_NEAR(total_volume(out), 1, 1e-14);
    for (std::size_t tet = 0; tet < out.tets.size(); ++tet) {
        EXPECT_EQ(out.regions[tet], tet_centroid(out, static_cast<int>(tet))[0] < 0.5 ? 3 : 4);
    }
    for (int i = 0; i < 3; ++i) EXPECT_EQ(out.vertices[out.surface[0].vertices[i]], mesh.vertices[mesh.surface[0].vertices[i]]);
    EXPECT_EQ(link_half_faces(out).opposite.size(), link_half_faces(mesh).opposite.size());
}

TEST(Morton, BringsNeighboursTogether) {
    const TetMesh mesh = test::kuhn_cube(8), out = in_morton_order(mesh);
    const auto upper_quartile_jump = [](const TetMesh& m) {  // between the numbers of tets that share a face
        std::vector<int> jumps;
        const HalfFaceLinks links = link_half_faces(m);
        for (std::size_t h = 0; h < links.opposite.size(); ++h) {
            if (links.opposite[h] >= 0) jumps.push_back(std::abs(links.opposite[h] / 4 - static_cast<int>(h / 4)));
        }
        std::nth_element(jumps.begin(), jumps.begin() + static_cast<long>(3 * jumps.size() / 4), jumps.end());
        return jumps[3 * jumps.size() / 4];
    };
    EXPECT_LT(2 * upper_quartile_jump(out), upper_quartile_jump(mesh));
}

}  // namespace
}  // namespace cleave::mesh
