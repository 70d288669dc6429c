#include "solver/fracture/criterion.hpp"

#include "solver/material/material.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cleave::fracture {
namespace {

constexpr double degree = std::numbers::pi / 180;

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return std::acos(std::min(std::abs(a.dot(b)), 1.0)); }

TEST(LargestPrincipal, OfATurnedDiagonalTensor) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
    const Eigen::Matrix3d tensor = turn * Eigen::Vector3d(-5, 2, 4).asDiagonal() * turn.transpose();
    const Principal principal = largest_principal(tensor);
    EXPECT_NEAR(principal.value, 4, 1e-14);
    EXPECT_LT(angle_between(principal.direction, turn.col(2)), 1e-7);
    EXPECT_NEAR(principal.gap, 2 / std::sqrt(45.0), 1e-14);
}

TEST(LargestPrincipal, OneOfBothNormalsAndTheGapAtItsEnds) {
    EXPECT_EQ(largest_principal(Eigen::Vector3d(0, 3, 0).asDiagonal()).direction, Eigen::Vector3d::UnitY());
    EXPECT_DOUBLE_EQ(largest_principal(Eigen::Vector3d(0, 3, 0).asDiagonal()).gap, 1);
    EXPECT_DOUBLE_EQ(largest_principal(Eigen::Vector3d(3, 3, 0).asDiagonal()).gap, 0);
    EXPECT_EQ(largest_principal(Eigen::Matrix3d::Zero()).gap, 0);
    const Eigen::Vector3d normal = Eigen::Vector3d(-0.1, -0.9, 0.3).normalized();
    EXPECT_GT(largest_principal(normal * normal.transpose()).direction.y(), 0) << "the largest component is positive";
}

/// Between the two criteria's directions under a stress.
double difference(const material::Stiffness& stiffness, const Eigen::Matrix3d& stress) {
    const material::Voigt s = material::stress_to_voigt(stress), e = material::compliance(stiffness) * s;
    return angle_between(rankine(s, e, Criterion::stress).direction, rankine(s, e, Criterion::strain).direction) / degree;
}

Eigen::Matrix3d uniaxial(double angle) {
    const Eigen::Vector3d pull(std::cos(angle), std::sin(angle), 0);
    return pull * pull.transpose();
}

// physics.md's figures, to its 0.1 degrees; the cases rankine_* have the reference computed by other code.
TEST(Rankine, StressAndStrainDifferInAnisotropicSolids) {
    const material::Stiffness fibre = material::find_material("T300/5208").stiffness;
    EXPECT_NEAR(difference(fibre, uniaxial(10 * degree)), 30.4, 0.1);
    EXPECT_NEAR(difference(fibre, Eigen::Vector3d(1, 0.1, 0).asDiagonal()), 90, 0.1);
    EXPECT_NEAR(difference(material::find_material("Sitka spruce").stiffness, uniaxial(15 * degree)), 27.1, 0.1);
    EXPECT_LT(difference(material::isotropic(7e10, 0.2), uniaxial(10 * degree)), 1e-5) << "none where isotropic";
}

}  // namespace
}  // namespace cleave::fracture
