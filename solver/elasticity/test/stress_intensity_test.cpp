#include "solver/elasticity/crack_tip_field.hpp"
#include "solver/material/stiffness.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cleave::elasticity {
namespace {

material::Stiffness triclinic() {
    material::Stiffness a;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) a(i, j) = std::sin(1.0 + 3 * i + 7 * j);
    return 1e9 * (60 * material::Stiffness::Identity() + 12 * a * a.transpose());
}

Eigen::Matrix3d stress_of(const material::Stiffness& c, const Eigen::Matrix3d& g) {
    return material::stress_from_voigt(c * material::strain_to_voigt(0.5 * (g + g.transpose())));
}

TEST(CrackTipField, IsotropicComplianceInClosedForm) {
    const CrackTipField field(material::isotropic(200e9, 0.3));
    const Eigen::Vector3d expected(2 * 0.91 / 200e9, 2 * 0.91 / 200e9, 2 * 1.3 / 200e9);
    EXPECT_LT((field.compliance() - Eigen::Matrix3d(expected.asDiagonal())).norm(), 1e-9 * expected.norm());
}

// Sih, Paris and Irwin (1965), plane strain, crack along the fibre: G_I = 0.057644, G_II = 0.0155441 for unit K, 1/GPa.
TEST(CrackTipField, OrthotropicComplianceOfSihParisAndIrwin) {
    const CrackTipField field(material::transversely_isotropic(181e9, 10.3e9, 7.17e9, 0.28, 0.47));
    EXPECT_NEAR(field.compliance()(1, 1) / 2 * 1e9, 0.057644, 1e-6);
    EXPECT_NEAR(field.compliance()(0, 0) / 2 * 1e9, 0.0155441, 1e-7);
}

TEST(CrackTipField, BalancedFreeOnTheLipsAndOfUnitIntensity) {
    const material::Stiffness c = triclinic();
    const CrackTipField field(c);
    const double step = 1e-4;
    for (int mode = 0; mode < 3; ++mode) {
        const Eigen::Vector3d ahead = stress_of(c, field.gradients(1, 0)[mode]).col(1) * std::sqrt(2 * std::numbers::pi);
        EXPECT_LT((ahead - Eigen::Vector3d::Unit(mode)).norm(), 1e-7);
        for (const double lip : {1e-12, -1e-12}) EXPECT_LT(stress_of(c, field.gradients(-1, lip)[mode]).col(1).norm(), 1e-7);
        for (const Eigen::Vector2d& x : {Eigen::Vector2d(0.3, 0.8), Eigen::Vector2d(-0.7, -0.4)}) {
            Eigen::Vector3d force = Eigen::Vector3d::Zero();
            for (int d = 0; d < 2; ++d) {
                const Eigen::Vector2d h = step * Eigen::Vector2d::Unit(d);
                force += (stress_of(c, field.gradients(x[0] + h[0], x[1] + h[1])[mode]) - stress_of(c, field.gradients(x[0] - h[0], x[1] - h[1])[mode])).col(d) / (2 * step);
            }
            EXPECT_LT(force.norm(), 1e-5);  // against stresses of order one
        }
    }
}

// The gradient is one of a displacement: its curl vanishes, (u_i,1),2 = (u_i,2),1.
TEST(CrackTipField, GradientsAreCompatible) {
    const CrackTipField field(triclinic());
    const double step = 1e-4;
    for (int mode = 0; mode < 3; ++mode) {
        const Eigen::Vector3d first = field.gradients(0.4, 0.3 + step)[mode].col(0) - field.gradients(0.4, 0.3 - step)[mode].col(0);
        const Eigen::Vector3d second = field.gradients(0.4 + step, 0.3)[mode].col(1) - field.gradients(0.4 - step, 0.3)[mode].col(1);
        EXPECT_LT((first - second).norm(), 1e-5 * first.norm());
    }
}

}  // namespace
}  // namespace cleave::elasticity
