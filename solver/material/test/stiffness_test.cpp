#include "solver/material/stiffness.hpp"

#include "solver/material/test/test_materials.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace cleave::material {
namespace {

using test::carbon_epoxy;
using test::random_rotation;
using test::random_triclinic;
using Eigen::Vector3d;

/// Hooke's law by Lame's constants, without the 6x6 form.
TEST(Stiffness, IsotropicIsLame) {
    const double E = 70e9, nu = 0.22, G = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    std::mt19937 generator(5);
    const Eigen::Matrix3d m = test::random_matrix(generator), strain = m + m.transpose();
    const Eigen::Matrix3d stress = lambda * strain.trace() * Eigen::Matrix3d::Identity() + 2 * G * strain;
    EXPECT_LT((stress_from_voigt(isotropic(E, nu) * strain_to_voigt(strain)) - stress).norm(), 1e-13 * stress.norm());
}

TEST(Stiffness, IsotropicLooksTheSameFromEverywhere) {
    std::mt19937 generator(6);
    const Stiffness c = isotropic(70e9, 0.22);
    for (int trial = 0; trial < 10; ++trial) {
        const Eigen::Matrix3d r = random_rotation(generator);
        EXPECT_LT((rotate_stiffness(c, r) - c).cwiseAbs().maxCoeff(), 1e-13 * c.maxCoeff());
        EXPECT_NEAR(youngs_modulus(c, r.col(0)), 70e9, 1e-13 * 70e9);
    }
    EXPECT_NEAR(universal_anisotropy(c), 0, 1e-12);
    EXPECT_NEAR(hill_youngs_modulus(c), 70e9, 1e-3);
}

/// Off-axis bar (Jones 1975, Eq. 2.97): 1/Ex = c^4/E1 + (1/G12 - 2 nu12/E1) s^2 c^2 + s^4/E2, at every ten degrees.
TEST(Stiffness, OffAxisModulusOfAFibreComposite) {
    const EngineeringConstants k = carbon_epoxy();
    const Stiffness c = orthotropic(k);
    for (int degrees = 0; degrees <= 90; degrees += 10) {
        const double angle = degrees * M_PI / 180, cc = std::cos(angle), ss = std::sin(angle);
        const double inverse = std::pow(cc, 4) / k.E1 + (1 / k.G12 - 2 * k.nu12 / k.E1) * ss * ss * cc * cc + std::pow(ss, 4) / k.E2;
        EXPECT_NEAR(youngs_modulus(c, Vector3d(cc, ss, 0)) * inverse, 1, 1e-12) << degrees;
    }
    EXPECT_NEAR(youngs_modulus(c, Vector3d(1, 1, 0)) * 1e-9, 16.74, 0.005);
    const EngineeringConstants stiffer{k.E1, k.E2, k.E3, k.G23, k.G13, 1.01 * k.G12, k.nu12, k.nu13, k.nu23};
    EXPECT_GT(std::abs(youngs_modulus(orthotropic(stiffer), Vector3d(1, 1, 0)) * 1e-9 - 16.74), 0.05)
        << "must fail twin: one per cent of G12 is seen";
}

/// The modulus along a direction is C turned so that the direction becomes x: two ways to the same number.
TEST(Stiffness, DirectionalModulusAgreesWithTurningTheMaterial) {
    std::mt19937 generator(7);
    for (int trial = 0; trial < 20; ++trial) {
        const Stiffness c = random_triclinic(generator);
        const Eigen::Matrix3d r = random_rotation(generator);
        const EngineeringConstants k = engineering_constants(rotate_stiffness(c, r.transpose()));
        EXPECT_NEAR(youngs_modulus(c, r.col(0)) / k.E1, 1, 1e-11);
        EXPECT_NEAR(shear_modulus(c, r.col(0), r.col(1)) / k.G12, 1, 1e-11);
        EXPECT_NEAR(poisson_ratio(c, r.col(0), r.col(2)), k.nu13, 1e-11);
        EXPECT_LT((kelvin_moduli(rotate_stiffness(c, r)) - kelvin_moduli(c)).cwiseAbs().maxCoeff(), 1e-11 * kelvin_moduli(c)(5));
    }
}

/// Silicon (Hopcroft 2010): E100 130, E110 169, E111 188 GPa; G100 79.6, G110 50.9; Poisson's ratios .2783, .0622, .3617.
TEST(Stiffness, SiliconAlongItsDirections) {
    const Stiffness c = cubic(165.7e9, 63.9e9, 79.6e9);
    EXPECT_NEAR(youngs_modulus(c, Vector3d(1, 0, 0)) * 1e-9, 130, 0.5);
    EXPECT_NEAR(youngs_modulus(c, Vector3d(1, 1, 0)) * 1e-9, 169, 0.5);
    EXPECT_NEAR(youngs_modulus(c, Vector3d(1, 1, 1)) * 1e-9, 188, 0.5);
    EXPECT_NEAR(shear_modulus(c, Vector3d(1, 0, 0), Vector3d(0, 1, 0)) * 1e-9, 79.6, 1e-9);
    EXPECT_NEAR(shear_modulus(c, Vector3d(1, 1, 0), Vector3d(1, -1, 0)) * 1e-9, 50.9, 1e-9);
    EXPECT_NEAR(poisson_ratio(c, Vector3d(1, 0, 0), Vector3d(0, 1, 0)), 0.2783, 5e-5);
    EXPECT_NEAR(poisson_ratio(c, Vector3d(1, 1, 0), Vector3d(1, -1, 0)), 0.0622, 5e-5);
    EXPECT_NEAR(poisson_ratio(c, Vector3d(1, 1, 0), Vector3d(0, 0, 1)), 0.3617, 5e-5);
}

TEST(Stiffness, EngineeringConstantsComeBack) {
    const EngineeringConstants k{10.89e9, 0.849e9, 0.468e9, 0.0327e9, 0.664e9, 0.697e9, 0.372, 0.467, 0.435};
    const EngineeringConstants back = engineering_constants(orthotropic(k));
    EXPECT_NEAR(back.E1 / k.E1, 1, 1e-13);
    EXPECT_NEAR(back.E3 / k.E3, 1, 1e-13);
    EXPECT_NEAR(back.G23 / k.G23, 1, 1e-13);
    EXPECT_NEAR(back.G12 / k.G12, 1, 1e-13);
    EXPECT_NEAR(back.nu12, k.nu12, 1e-13);
    EXPECT_NEAR(back.nu23, k.nu23, 1e-13);
}

/// Five constants are a special case of nine, and turning about the fibre changes nothing.
TEST(Stiffness, TransverseIsotropy) {
    const Stiffness c = transversely_isotropic(181e9, 10.3e9, 7.17e9, 0.28, 0.47);
    EXPECT_LT((c - orthotropic(carbon_epoxy())).cwiseAbs().maxCoeff(), 1e-13 * c.maxCoeff());
    const Eigen::Matrix3d about_fibre = Eigen::AngleAxisd(0.7, Vector3d::UnitX()).toRotationMatrix();
    EXPECT_LT((rotate_stiffness(c, about_fibre) - c).cwiseAbs().maxCoeff(), 1e-13 * c.maxCoeff());
    const Eigen::Matrix3d about_z = Eigen::AngleAxisd(0.7, Vector3d::UnitZ()).toRotationMatrix();
    EXPECT_GT((rotate_stiffness(c, about_z) - c).cwiseAbs().maxCoeff(), 0.1 * c.maxCoeff()) << "must fail twin";
}

/// Orthotropic brick (ANSYS verification manual, VM145): strains of a unit cube in psi and inches.
TEST(Stiffness, OrthotropicBrick) {
    const double E1 = 10e6, E2 = 20e6, E3 = 40e6, G = 10e6;
    // Minor ratios .1, .2, .3 are given with S12 = -nu_xy / Ey; here nu_ij / E_i.
    const Stiffness c = orthotropic({E1, E2, E3, G, G, G, 0.1 * E1 / E2, 0.3 * E1 / E3, 0.2 * E2 / E3});
    Voigt stress;
    stress << 100, 200, 0, 0, 0, 0;
    const Voigt strain = compliance(c) * stress;
    EXPECT_NEAR(strain(0), 9e-6, 1e-18);
    EXPECT_NEAR(strain(1), 9.5e-6, 1e-18);
    EXPECT_NEAR(strain(2), -1.75e-6, 1e-18);
}

/// Hill's mean lies between Reuss and Voigt; for silicon Hopcroft's polycrystal average is 160 to 163 GPa.
TEST(Stiffness, HillAverage) {
    const double E = hill_youngs_modulus(cubic(165.7e9, 63.9e9, 79.6e9)) * 1e-9;
    EXPECT_GT(E, 159);
    EXPECT_LT(E, 165);
    // 6/5 (sqrt A - 1/sqrt A)^2 for a cubic crystal (Ranganathan and Ostoja-Starzewski 2008, Eq. 12), A = 2 C44 / (C11 - C12).
    const double A = 2 * 79.6 / (165.7 - 63.9);
    EXPECT_NEAR(universal_anisotropy(cubic(165.7e9, 63.9e9, 79.6e9)), 1.2 * std::pow(std::sqrt(A) - 1 / std::sqrt(A), 2), 1e-12);
}

std::string rejection(const Stiffness& c) {
    try {
        checked_stiffness(c);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Stiffness, WhatIsNotAStiffnessIsRejected) {
    Stiffness c = isotropic(70e9, 0.22);
    EXPECT_EQ(rejection(c), "accepted");
    Stiffness skew = c;
    skew(0, 1) *= 1.001;
    EXPECT_EQ(rejection(skew), "a symmetric stiffness");
    Stiffness indefinite = c;
    indefinite(3, 3) = -1.5e9;  // Kelvin's basis doubles a shear modulus
    EXPECT_EQ(rejection(indefinite), "a positive definite stiffness (smallest eigenvalue -3 GPa)");
    Stiffness broken = c;
    broken(2, 2) = std::nan("");
    EXPECT_EQ(rejection(broken), "a stiffness of finite numbers");
    EXPECT_THROW(isotropic(70e9, 0.5), std::invalid_argument);
    EXPECT_THROW(cubic(100e9, 101e9, 50e9), std::invalid_argument);
    EngineeringConstants k = carbon_epoxy();
    k.nu23 = 1.1;
    EXPECT_THROW(orthotropic(k), std::invalid_argument);
}

TEST(Stiffness, TwentyOneConstantsFillTheTriangle) {
    std::mt19937 generator(8);
    const Stiffness c = random_triclinic(generator);
    std::array<double, 21> constants{};
    std::size_t at = 0;
    for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) constants[at++] = c(i, j);
    EXPECT_EQ(from_upper_triangle(constants), c);
}

}  // namespace
}  // namespace cleave::material
