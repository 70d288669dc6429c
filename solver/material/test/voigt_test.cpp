#include "solver/material/test/test_materials.hpp"
#include "solver/material/voigt.hpp"

#include <gtest/gtest.h>

namespace cleave::material {
namespace {

using test::random_matrix;
using test::random_rotation;
using test::random_triclinic;

TEST(Voigt, OrderAndEngineeringShear) {
    Eigen::Matrix3d m;
    m << 1, 6, 5, 6, 2, 4, 5, 4, 3;
    Voigt stress, strain;
    stress << 1, 2, 3, 4, 5, 6;
    strain << 1, 2, 3, 8, 10, 12;
    EXPECT_EQ(stress_to_voigt(m), stress);
    EXPECT_EQ(strain_to_voigt(m), strain);
    EXPECT_EQ(stress_from_voigt(stress), m);
    EXPECT_EQ(strain_from_voigt(strain), m);
}

/// Simple shear against a known modulus: u_x = g y gives sigma_xy = G g. A tensor shear in place of g would give G g / 2.
TEST(Voigt, SimpleShearGivesTheShearModulus) {
    const double G = 28e9, shear = 1e-3;
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    gradient(0, 1) = shear;
    const Eigen::Matrix3d strain = 0.5 * (gradient + gradient.transpose());
    const Voigt stress = isotropic(2.4 * G, 0.2) * strain_to_voigt(strain);
    EXPECT_NEAR(stress(5), G * shear, 1e-6 * G * shear);
    const Voigt confused = isotropic(2.4 * G, 0.2) * stress_to_voigt(strain);
    EXPECT_NEAR(confused(5), 0.5 * G * shear, 1e-6 * G * shear) << "must fail twin: the factor-2 error would be seen";
}

/// The product of stress and strain is the same number as matrices and as Voigt vectors.
TEST(Voigt, WorkIsTheSameInBothForms) {
    std::mt19937 generator(1);
    const Eigen::Matrix3d a = random_matrix(generator), b = random_matrix(generator);
    const Eigen::Matrix3d stress = a + a.transpose(), strain = b + b.transpose();
    EXPECT_NEAR(stress_to_voigt(stress).dot(strain_to_voigt(strain)), stress.cwiseProduct(strain).sum(), 1e-12);
}

/// Bond's matrices against the definition of a fourth-order tensor. 1e-13: rounding of sums of 81 products.
TEST(Rotation, BondAgreesWithTheTensorDefinition) {
    std::mt19937 generator(2);
    for (int trial = 0; trial < 20; ++trial) {
        const Stiffness c = random_triclinic(generator);
        const Eigen::Matrix3d r = random_rotation(generator);
        const Stiffness bond = rotate_stiffness(c, r), tensor = rotate_stiffness_by_components(c, r);
        EXPECT_LT((bond - tensor).cwiseAbs().maxCoeff(), 1e-13 * c.cwiseAbs().maxCoeff());
        EXPECT_GT((bond - c).cwiseAbs().maxCoeff(), 1e-2 * c.cwiseAbs().maxCoeff()) << "the rotation must do something";
        EXPECT_GT((rotate_stiffness(c, r.transpose()) - tensor).cwiseAbs().maxCoeff(), 1e-2 * c.cwiseAbs().maxCoeff())
            << "must fail twin: the inverse rotation is seen";
    }
}

/// Covariance: the stress of a turned strain in the turned material is the turned stress.
TEST(Rotation, StressTurnsWithTheMaterial) {
    std::mt19937 generator(3);
    for (int trial = 0; trial < 20; ++trial) {
        const Stiffness c = random_triclinic(generator);
        const Eigen::Matrix3d r = random_rotation(generator), m = random_matrix(generator);
        const Eigen::Matrix3d strain = m + m.transpose();
        const Eigen::Matrix3d stress = stress_from_voigt(c * strain_to_voigt(strain));
        const Eigen::Matrix3d turned =
            stress_from_voigt(rotate_stiffness(c, r) * strain_to_voigt(r * strain * r.transpose()));
        EXPECT_LT((turned - r * stress * r.transpose()).norm(), 1e-13 * stress.norm() * 10);
    }
}

TEST(Rotation, ComposesAndInverts) {
    std::mt19937 generator(4);
    const Stiffness c = random_triclinic(generator);
    const Eigen::Matrix3d a = random_rotation(generator), b = random_rotation(generator);
    const double scale = c.cwiseAbs().maxCoeff();
    EXPECT_LT((rotate_stiffness(rotate_stiffness(c, a), b) - rotate_stiffness(c, b * a)).cwiseAbs().maxCoeff(), 1e-13 * scale);
    EXPECT_LT((rotate_stiffness(rotate_stiffness(c, a), a.transpose()) - c).cwiseAbs().maxCoeff(), 1e-13 * scale);
}

}  // namespace
}  // namespace cleave::material
