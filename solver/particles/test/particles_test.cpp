#include "solver/particles/particles.hpp"

#include "solver/particles/test/box_mesh.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>
#include <stdexcept>

namespace cleave::particles {
namespace {

TEST(Particles, KeepVolumeAndCentre) {
    const Particles particles = from_mesh(test::box_mesh(5));
    ASSERT_EQ(particles.size(), 6 * 125);
    double volume = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (int i = 0; i < particles.size(); ++i) {
        volume += particles.volume[i];
        centre += particles.volume[i] * particles.position[i];
        EXPECT_NEAR(4 * std::numbers::pi / 3 * std::pow(particles.radius[i], 3), particles.volume[i], 1e-14);
    }
    EXPECT_NEAR(volume, 1, 1e-13);
    EXPECT_LT((centre - Eigen::Vector3d::Constant(0.5)).norm(), 1e-13);
}

TEST(Particles, UniformMeshHasOneSpacing) {
    const int n = 4;
    const Particles particles = from_mesh(test::box_mesh(n, 0));
    for (int i = 0; i < particles.size(); ++i) {
        EXPECT_NEAR(particles.spacing[i], std::cbrt(1.0 / (6 * n * n * n)), 1e-14);
        EXPECT_DOUBLE_EQ(particles.support_radius[i], 2.5 * particles.spacing[i]);
        EXPECT_NEAR(particles.tensor[i].determinant() * std::pow(particles.support_radius[i], 3), 1, 1e-13);
    }
}

/// Tet volumes range over a factor of about 4^3 here: the spacing must follow, and must be smoother than V^(1/3).
TEST(Particles, GradedMeshHasLocalSpacing) {
    const Particles particles = from_mesh(test::box_mesh(8, 0.2, test::graded(4)));
    double smallest = 1, largest = 0;
    for (int i = 0; i < particles.size(); ++i) {
        const double ratio = particles.spacing[i] / std::cbrt(particles.volume[i]);
        EXPECT_GT(ratio, 0.7);
        EXPECT_LT(ratio, 1.8);
        smallest = std::min(smallest, particles.spacing[i]);
        largest = std::max(largest, particles.spacing[i]);
    }
    EXPECT_GT(largest / smallest, 3);
}

/// One flat tet keeps the spacing of its surroundings.
TEST(Particles, ASliverDoesNotShrinkASupport) {
    mesh::TetMesh mesh = test::box_mesh(4, 0);
    const Particles before = from_mesh(mesh);
    const std::array<int, 4> tet = mesh.tets[100];
    const Eigen::Vector3d& a = mesh.vertices[tet[1]];
    const Eigen::Vector3d normal = (mesh.vertices[tet[2]] - a).cross(mesh.vertices[tet[3]] - a).normalized();
    Eigen::Vector3d& apex = mesh.vertices[tet[0]];
    apex -= 0.98 * normal.dot(apex - a) * normal;
    mesh.tets = {mesh.tets.begin(), mesh.tets.end()};
    std::vector<std::array<int, 4>> positive;
    for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t)
        if (mesh::tet_volume(mesh, t) > 0) positive.push_back(mesh.tets[t]);
    mesh.tets = positive;
    mesh.regions.assign(positive.size(), 0);
    const Particles after = from_mesh(mesh);
    const int sliver = static_cast<int>(std::min_element(after.volume.begin(), after.volume.end()) - after.volume.begin());
    EXPECT_LT(after.volume[sliver], 0.05 * before.volume[0]);
    EXPECT_GT(after.spacing[sliver], 0.8 * before.spacing[0]);
}

TEST(Particles, RegionsAreKeptAndInvertedTetsRefused) {
    mesh::TetMesh mesh = test::box_mesh(2);
    mesh.regions[7] = 3;
    EXPECT_EQ(from_mesh(mesh).region[7], 3);
    mesh.regions.clear();
    EXPECT_EQ(from_mesh(mesh).region[7], 0);
    std::swap(mesh.tets[5][0], mesh.tets[5][1]);
    EXPECT_THROW(from_mesh(mesh), std::invalid_argument);
}

}  // namespace
}  // namespace cleave::particles
