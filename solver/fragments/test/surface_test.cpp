#include "solver/fragments/surface.hpp"

#include "solver/fragments/test/invariants.hpp"
#include "solver/mesh/test/test_meshes.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace cleave::fragments {
namespace {

using Eigen::Vector3d;
using mesh::test::kuhn_cube;

double area(const Surface& skin, bool crack) {
    double sum = 0;
    for (const SurfaceFace& face : skin.faces) {
        const Vector3d &a = skin.points[face.points[0]], &b = skin.points[face.points[1]], &c = skin.points[face.points[2]];
        if (face.crack == crack) sum += 0.5 * (b - a).cross(c - a).norm();
    }
    return sum;
}

TEST(Surface, OfAnUncrackedCubeIsItsSixSides) {
    const FragmentedBody body(kuhn_cube(3, 0.1));
    const Surface skin = surface(body, body.fragment(0));
    EXPECT_EQ(skin.faces.size(), 6u * 9 * 2);
    EXPECT_EQ(skin.points.size(), 56u);  // 4^3 - 2^3
    EXPECT_NEAR(area(skin, false), 6, 1e-13);
    EXPECT_EQ(area(skin, true), 0);
    EXPECT_EQ(open_edges(skin), 0);
    EXPECT_NEAR(enclosed_volume(skin), 1, 1e-14);
}

TEST(Surface, ACrackFaceHasTheAreaOfTheSection) {
    FragmentedBody body(kuhn_cube(4, 0.1), Scheme::adaptive, {.tau = 0});
    body.crack({.disc = {.centre = {0.5, 0.5, 0.47}, .normal = {0, 0, 1}}}, 0);
    for (const int number : body.current_fragments()) {
        const Surface skin = surface(body, body.fragment(number));
        EXPECT_NEAR(area(skin, true), 1, 1e-13);
        EXPECT_NEAR(area(skin, false), number == 1 ? 2 + 4 * 0.47 - 1 : 2 + 4 * 0.53 - 1, 1e-13);
    }
}

TEST(Surface, OpenCracksInsideHaveTwoLips) {
    FragmentedBody body(kuhn_cube(6, 0.1), Scheme::adaptive, {.tau = 0});
    body.crack({.disc = {.centre = {0.5, 0.5, 0.45}, .normal = {0, 0, 1}, .radius = 0.35}}, 0);
    const Surface skin = surface(body, body.fragment(0));
    EXPECT_EQ(open_edges(skin), 0);
    EXPECT_NEAR(enclosed_volume(skin), 1, 1e-12);  // lips enclose nothing
    // Links are removed where they cross the disc: its two lips, to within the size of the tets at the front (1/6 and less).
    EXPECT_GT(area(skin, true), 2 * 3.14159 * 0.25 * 0.25);
    EXPECT_LT(area(skin, true), 2 * 3.14159 * 0.45 * 0.45);
}

class OpenEdges : public testing::Test {
protected:
    OpenEdges() { body_.crack({.disc = {.centre = {0.5, 0.5, 0.5}, .normal = {1, 0.4, 0.3}}}, 0); }
    FragmentedBody body_{kuhn_cube(3, 0.1)};
};

TEST_F(OpenEdges, SeeAMissingTriangle) {
    Surface skin = surface(body_, body_.fragment(1));
    ASSERT_EQ(open_edges(skin), 0);
    skin.faces.pop_back();
    EXPECT_EQ(open_edges(skin), 3);
}

TEST_F(OpenEdges, SeeATriangleTurnedOver) {
    Surface skin = surface(body_, body_.fragment(1));
    const double volume = enclosed_volume(skin);
    std::swap(skin.faces.back().points[0], skin.faces.back().points[1]);  // far from the first point, the volumes' origin
    EXPECT_GT(open_edges(skin), 0);
    EXPECT_GT(std::abs(enclosed_volume(skin) - volume), 1e-6);
}

}  // namespace
}  // namespace cleave::fragments
