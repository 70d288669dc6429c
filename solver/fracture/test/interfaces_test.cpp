#include "solver/fracture/interfaces.hpp"

#include "solver/particles/test/box_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::fracture {
namespace {

/// A lattice of 4 x 4 x 4 m; material by the cell's x: 0 below 2, 1 from 2 on; jittered, but for the interface.
struct TwoMaterials {
    mesh::TetMesh mesh = particles::test::lattice_mesh({4, 4, 4}, 0, [](const Eigen::Vector3d& x) { return x; });
    std::vector<int> material;

    TwoMaterials() {
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) material.push_back(mesh::tet_centroid(mesh, static_cast<int>(t)).x() > 2);
    }
};

TEST(InterfaceFaces, AreThePlaneBetweenTheMaterials) {
    const TwoMaterials body;
    const auto faces = interface_faces(body.mesh, body.material);
    double area = 0;
    for (const InterfaceFace& face : faces) {
        const Eigen::Vector3d twice = (face.corner[1] - face.corner[0]).cross(face.corner[2] - face.corner[0]);
        area += 0.5 * twice.norm();
        EXPECT_NE(face.material[0], face.material[1]);
        for (const auto& corner : face.corner) EXPECT_EQ(corner.x(), 2);
        EXPECT_GT(twice.x() * (face.material[1] - face.material[0]), 0) << "points from the first material into the second";
    }
    EXPECT_DOUBLE_EQ(area, 16);
    EXPECT_TRUE(interface_faces(body.mesh, std::vector<int>(body.material.size(), 0)).empty());
}

TEST(InterfaceHits, NearestPointOfTheDiscOnTheInterface) {
    const TwoMaterials body;
    const auto faces = interface_faces(body.mesh, body.material);
    // A disc about (0.7, 1.9, 2.3), normal across (1, 0.2, 0): it meets x = 2 along a vertical line, nearest at its own height.
    const Eigen::Vector3d centre(0.7, 1.9, 2.3), along = Eigen::Vector3d(1, 0.2, 0).normalized(), normal(-along.y(), along.x(), 0);
    const double distance = 1.3 / along.x();
    const auto hits = interface_hits(faces, 0, centre, normal, 1.01 * distance);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_LT((hits[0].position - (centre + distance * along)).norm(), 1e-12);
    EXPECT_LT((hits[0].normal - Eigen::Vector3d::UnitX()).norm(), 1e-12);
    EXPECT_EQ(hits[0].to, 1);
    EXPECT_TRUE(interface_hits(faces, 0, centre, normal, 0.99 * distance).empty()) << "too short to reach it";
    EXPECT_TRUE(interface_hits(faces, 0, centre, Eigen::Vector3d::UnitX(), 5).empty()) << "parallel to it";
    const auto back = interface_hits(faces, 1, Eigen::Vector3d(3, 2, 2), Eigen::Vector3d::UnitY(), 2);
    ASSERT_EQ(back.size(), 1u);
    EXPECT_EQ(back[0].to, 0);
    EXPECT_LT(back[0].normal.x(), -0.99);
}

/// Two faces of a roof, its ridge along y at x = 1, meet a level crack from x = 0 first in the ridge: the normal is that of both together,
/// whichever is listed first.
TEST(InterfaceHits, AnEdgeHasTheMeanNormalOfItsFaces) {
    const Eigen::Vector3d front(1, -1, 0), back(1, 1, 0), low(2, 0, -1), high(3, 0, 0.7);
    std::vector<InterfaceFace> roof{{{front, low, back}, {0, 1}, {0, 1}}, {{front, back, high}, {0, 1}, {0, 1}}};
    const auto normal_of = [](const InterfaceFace& face) { return (face.corner[1] - face.corner[0]).cross(face.corner[2] - face.corner[0]).normalized(); };
    const Eigen::Vector3d mean = (normal_of(roof[0]) + normal_of(roof[1])).normalized();
    const auto hit = [&] { return interface_hits(roof, 0, Eigen::Vector3d(0, 0.2, 0), Eigen::Vector3d(0, 1, 0.3).normalized(), 5).at(0); };
    const InterfaceHit one = hit();
    std::swap(roof[0], roof[1]);
    EXPECT_LT((one.position - Eigen::Vector3d(1, 0.2, 0)).norm(), 1e-15);
    EXPECT_LT((one.normal - mean).norm(), 1e-15);
    EXPECT_LT((hit().normal - mean).norm(), 1e-15);
}

}  // namespace
}  // namespace cleave::fracture
