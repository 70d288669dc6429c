#include "solver/material/elastic_extremes.hpp"

#include "solver/material/material.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace cleave::material {
namespace {

const Stiffness silicon = cubic(165.7e9, 63.9e9, 79.6e9);

// Cubic crystals: Young's modulus is extreme along 100 and 111 (Nye 1985), the shear modulus on 100 and (110)[1-10].
TEST(ElasticExtremes, CubicCrystalsHaveThemAlongKnownDirections) {
    const Stiffness s = compliance(silicon);
    const Extremes young = youngs_modulus_extremes(silicon);
    EXPECT_NEAR(young.smallest.value * s(0, 0), 1, 1e-12);
    const double along_111 = 3 / (s(0, 0) + 2 * s(0, 1) + s(3, 3));
    EXPECT_NEAR(young.largest.value / along_111, 1, 1e-12);
    EXPECT_NEAR(young.largest.first.cwiseAbs().minCoeff(), std::sqrt(1.0 / 3), 1e-6);
    const Extremes shear = shear_modulus_extremes(silicon);
    EXPECT_NEAR(shear.largest.value / 79.6e9, 1, 1e-12);
    EXPECT_NEAR(shear.smallest.value / (0.5 * (165.7e9 - 63.9e9)), 1, 1e-12);
}

// Poisson's ratio of a cubic crystal, load along 110: (110 -> 001) the largest, (110 -> 1-10) the smallest (Norris 2006), for s11 - s12 > s44 / 2.
TEST(ElasticExtremes, PoissonsRatioOfSilicon) {
    const Extremes ratio = poisson_ratio_extremes(silicon);
    EXPECT_NEAR(ratio.largest.value, 0.3617, 5e-5);
    EXPECT_NEAR(ratio.smallest.value, 0.0622, 5e-5);
    EXPECT_NEAR(ratio.largest.value, poisson_ratio(silicon, {1, 1, 0}, {0, 0, 1}), 1e-12);
    EXPECT_NEAR(ratio.largest.first.dot(ratio.largest.second), 0, 1e-12);
}

TEST(ElasticExtremes, AreThoseOfTheTurnedCrystalAndNoneWhereIsotropic) {
    const Stiffness quartz = find_material("quartz").stiffness;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.83, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    const Stiffness turned = rotate_stiffness(quartz, turn);
    for (const auto search : {youngs_modulus_extremes, shear_modulus_extremes, poisson_ratio_extremes}) {
        const Extremes a = search(quartz), b = search(turned);
        EXPECT_NEAR(b.smallest.value / a.smallest.value, 1, 1e-10);
        EXPECT_NEAR(b.largest.value / a.largest.value, 1, 1e-10);
        EXPECT_GT(std::abs(a.largest.value - a.smallest.value), 0.1 * std::abs(a.largest.value));
    }
    const Extremes glass = youngs_modulus_extremes(isotropic(70e9, 0.2));
    EXPECT_NEAR(glass.smallest.value / 70e9, 1, 1e-12);
    EXPECT_NEAR(glass.largest.value / 70e9, 1, 1e-12);
}

// Longitudinal and transverse waves of an isotropic solid; the three of a cubic crystal along 110 (Auld 1973).
TEST(WaveSpeeds, KnownOnes) {
    const double rho = 2329;
    const Eigen::Vector3d glass = wave_speeds(isotropic(70e9, 0.2), 2500, {1, -2, 3});
    const double shear = 70e9 / 2.4, longitudinal = 2 * shear * (1 - 0.2) / (1 - 0.4);
    EXPECT_NEAR(glass[0] / std::sqrt(shear / 2500), 1, 1e-12);
    EXPECT_NEAR(glass[1] / std::sqrt(shear / 2500), 1, 1e-12);
    EXPECT_NEAR(glass[2] / std::sqrt(longitudinal / 2500), 1, 1e-12);
    const Eigen::Vector3d along_110 = wave_speeds(silicon, rho, {1, 1, 0});
    EXPECT_NEAR(along_110[0] / std::sqrt((165.7e9 - 63.9e9) / (2 * rho)), 1, 1e-12);
    EXPECT_NEAR(along_110[1] / std::sqrt(79.6e9 / rho), 1, 1e-12);
    EXPECT_NEAR(along_110[2] / std::sqrt((165.7e9 + 63.9e9 + 2 * 79.6e9) / (2 * rho)), 1, 1e-12);
    EXPECT_THROW(wave_speeds(silicon, 0, {1, 0, 0}), std::invalid_argument);
}

// Cubic aggregates in closed form: K = (C11 + 2 C12)/3 both ways, 5 G_V = C11 - C12 + 3 C44, G_R = 5 (C11 - C12) C44 / (4 C44 + 3 (C11 - C12)).
TEST(AggregateModuli, OfACubicCrystal) {
    const double a = 165.7e9 - 63.9e9, c = 79.6e9, bulk = (165.7e9 + 2 * 63.9e9) / 3;
    EXPECT_NEAR(voigt_moduli(silicon).bulk / bulk, 1, 1e-12);
    EXPECT_NEAR(reuss_moduli(silicon).bulk / bulk, 1, 1e-12);
    EXPECT_NEAR(voigt_moduli(silicon).shear / ((a + 3 * c) / 5), 1, 1e-12);
    EXPECT_NEAR(reuss_moduli(silicon).shear / (5 * a * c / (4 * c + 3 * a)), 1, 1e-12);
    EXPECT_LT(reuss_moduli(silicon).shear, 0.99 * voigt_moduli(silicon).shear) << "the bounds part";
    const AggregateModuli glass = hill_moduli(isotropic(70e9, 0.2));
    EXPECT_NEAR(glass.young() / 70e9, 1, 1e-12);
    EXPECT_NEAR(glass.poisson(), 0.2, 1e-12);
}

}  // namespace
}  // namespace cleave::material
