#include "solver/rigid/boundary_particles.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace cleave::rigid {
namespace {

/// A plane of n x n particles, spacing 1, of different masses.
std::vector<SurfaceParticle> sheet(int n) {
    std::vector<SurfaceParticle> surface;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) surface.push_back({{1.0 * i, 1.0 * j, 0.01 * (i * j % 7)}, 1, 1 + 0.1 * (i + 3 * j), i * n + j});
    return surface;
}

TEST(BoundaryParticles, EverySurfaceParticleIsInExactlyOne) {
    const auto surface = sheet(13);
    std::set<int> seen;
    for (const BoundaryParticle& particle : boundary_particles(surface))
        for (const int member : particle.members) EXPECT_TRUE(seen.insert(member).second) << member;
    EXPECT_EQ(seen.size(), surface.size());
}

TEST(BoundaryParticles, MassAndFirstMomentAreThoseOfTheMembers) {
    const auto surface = sheet(20);
    double mass = 0, own = 0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero(), own_moment = Eigen::Vector3d::Zero();
    for (const SurfaceParticle& p : surface) {
        mass += p.mass;
        moment += p.mass * p.position;
    }
    for (const BoundaryParticle& p : boundary_particles(surface)) {
        own += p.mass;
        own_moment += p.mass * p.position;
    }
    EXPECT_NEAR(own, mass, 1e-12 * mass);                           // 400 additions in another order
    EXPECT_LT((own_moment - moment).norm(), 1e-12 * moment.norm());
}

TEST(BoundaryParticles, GroupsOfFourAndSinglesOnly) {
    int groups = 0;
    const auto surface = sheet(20);
    const auto particles = boundary_particles(surface);
    for (const BoundaryParticle& p : particles) {
        EXPECT_TRUE(p.members.size() == 4 || p.members.size() == 1);
        groups += p.members.size() == 4;
        EXPECT_NEAR(p.radius, std::cbrt(3.0 * static_cast<double>(p.members.size()) / (4 * std::numbers::pi)), 1e-14);
    }
    const double ratio = static_cast<double>(surface.size()) / static_cast<double>(particles.size());
    EXPECT_GE(ratio, 2.5);  // the paper's bodies lie between 2.5 and 4 to one
    EXPECT_LE(ratio, 4);
    EXPECT_GT(groups, 0);
}

TEST(BoundaryParticles, MembersLieWithinReachOfTheirSeed) {
    const auto surface = sheet(15);
    for (const BoundaryParticle& p : boundary_particles(surface, {.group = 4, .reach = 1.5}))
        for (const int member : p.members) EXPECT_LE((surface[member].position - surface[p.members[0]].position).norm(), 1.5);
}

TEST(BoundaryParticles, FarApartTheyStayAlone) {
    std::vector<SurfaceParticle> surface;
    for (int i = 0; i < 5; ++i) surface.push_back({{3.0 * i, 0, 0}, 1, 1, i});
    EXPECT_EQ(boundary_particles(surface).size(), 5u);
    EXPECT_TRUE(boundary_particles({}).empty());
}

TEST(BoundaryParticles, TheOrderOfTheListDoesNotMatter) {
    auto surface = sheet(12);
    const auto forward = boundary_particles(surface);
    std::reverse(surface.begin(), surface.end());
    const auto backward = boundary_particles(surface);
    ASSERT_EQ(forward.size(), backward.size());
    // Ties of distance may go to another neighbour: the counts are the same, the seeds too.
    for (std::size_t i = 0; i < forward.size(); ++i) EXPECT_EQ(forward[i].members.size(), backward[i].members.size());
}

}  // namespace
}  // namespace cleave::rigid
