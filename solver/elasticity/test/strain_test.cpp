#include "solver/elasticity/strain.hpp"

#include "solver/elasticity/test/test_fields.hpp"

#include <gtest/gtest.h>

namespace cleave::elasticity {
namespace {

using material::Voigt;

material::Stiffness triclinic() {
    material::Stiffness a;
    a << 5, 1, 2, 1, 0, 1, 0, 4, 1, 0, 1, 2, 1, 0, 6, 1, 1, 0, 0, 1, 0, 3, 1, 0, 1, 0, 1, 0, 4, 1, 0, 1, 0, 1, 0, 2;
    return 1e9 * (a * a.transpose());
}

TEST(Strain, EngineeringShearAndNoRotation) {
    Eigen::Matrix3d gradient;
    gradient << 1, 2, 3, 4, 5, 6, 7, 8, 9;
    Voigt expected;
    expected << 1, 5, 9, 14, 10, 6;
    EXPECT_EQ(strain_of(gradient), expected);
    const Eigen::Matrix3d spin = gradient - gradient.transpose();
    EXPECT_EQ(strain_of(spin), Voigt::Zero());
}

/// A linear field in any material: strain, stress and energy are known everywhere, and the energy is that of the body.
TEST(Fields, LinearFieldInATriclinicSolid) {
    particles::Particles particles = particles::from_mesh(test::box_mesh(5));
    const auto op = make_strain_operator("corrected", particles, particles::build_neighbourhood(particles));
    const test::Field field = test::linear_field();
    const material::Stiffness c = triclinic();
    const Fields fields = evaluate(op, particles, uniform_solid(c, particles.size()), test::sample(field, particles));
    const Eigen::Matrix3d a = field.gradient({});
    const Voigt strain = material::strain_to_voigt(0.5 * (a + a.transpose()));
    for (int i = 0; i < particles.size(); ++i) {
        EXPECT_LT((fields.strain[i] - strain).norm(), 1e-12 * strain.norm() * 5);
        EXPECT_LT((fields.stress[i] - c * strain).norm(), 1e-12 * (c * strain).norm() * 5);
    }
    const double energy = 0.5 * strain.dot(c * strain);
    EXPECT_NEAR(fields.total_energy() / energy, 1, 1e-11);
    const Voigt tensor_shear = material::stress_to_voigt(0.5 * (a + a.transpose()));
    EXPECT_GT(std::abs(0.5 * tensor_shear.dot(c * strain) / energy - 1), 0.05)
        << "must fail twin: tensor shear in the energy would be seen";
}

TEST(Fields, EachParticleHasItsMaterial) {
    particles::Particles particles = particles::from_mesh(test::box_mesh(3));
    const auto op = make_strain_operator("corrected", particles, particles::build_neighbourhood(particles));
    Solid solid{{triclinic(), 2 * triclinic()}, std::vector<int>(particles.size(), 0)};
    solid.material[17] = 1;
    const auto u = test::sample(test::linear_field(), particles);
    const Fields one = evaluate(op, particles, uniform_solid(triclinic(), particles.size()), u);
    const Fields two = evaluate(op, particles, solid, u);
    EXPECT_EQ(two.stress[16], one.stress[16]);
    EXPECT_EQ(two.stress[17], 2 * one.stress[17]);
}

}  // namespace
}  // namespace cleave::elasticity
