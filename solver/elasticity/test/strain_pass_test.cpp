#include "solver/elasticity/strain_pass.hpp"
#include "solver/elasticity/test/test_fields.hpp"

#include <gtest/gtest.h>

namespace cleave::elasticity {
namespace {

/// A triclinic stiffness, dominated by its diagonal.
material::Stiffness stiffness() {
    material::Stiffness c = material::Stiffness::Identity() * 3;
    for (int a = 0; a < 6; ++a)
        for (int b = 0; b < 6; ++b) c(a, b) += 0.1 * std::cos(1.0 + a * b + a + b);
    return c;
}

struct Body {
    particles::Particles particles;
    particles::NeighbourLists lists;
    std::vector<Eigen::Vector3d> displacement;
    Solid solid;

    explicit Body(particles::Particles of) : particles(std::move(of)), lists(particles::build_neighbourhood(particles).lists) {
        displacement = test::sample(test::smooth_field(), particles);
        solid = uniform_solid(stiffness(), particles.size());
    }
};

particles::Particles stretched(double aspect) {
    particles::Particles particles = particles::from_mesh(test::box_mesh(6));
    std::mt19937 generator(3);
    particles::test::stretch_kernels(particles, aspect, generator);
    return particles;
}

double largest_difference(const Fields& a, const Fields& b) {
    EXPECT_EQ(a.gradient.size(), b.gradient.size());
    double worst = 0;
    for (std::size_t i = 0; i < a.gradient.size(); ++i) {
        worst = std::max({worst, (a.gradient[i] - b.gradient[i]).norm(), (a.strain[i] - b.strain[i]).norm(),
                          (a.stress[i] - b.stress[i]).norm() / 3, std::abs(a.energy[i] - b.energy[i])});
    }
    return worst;
}

TEST(StrainPass, equals_the_plain_loop_to_rounding) {
    for (const double aspect : {1.0, 4.0}) {
        const Body body(stretched(aspect));
        StrainPass pass(body.particles, body.lists, body.solid);
        Fields fast, plain;
        pass.evaluate(body.displacement, fast);
        plain_strain_pass(body.particles, body.lists, body.solid, body.displacement, plain);
        // Sums of about a hundred terms of the size of the gradient (2), in another order, times the condition of K: below 40 by
        // SupportRule.
        EXPECT_LT(largest_difference(fast, plain), 1e-12) << "aspect " << aspect;
        EXPECT_EQ(pass.fallbacks(), 0);
        EXPECT_LT(largest_difference(fast, evaluate(make_strain_operator("corrected", body.particles, {body.lists, {}}), body.particles,
                                                    body.solid, body.displacement)), 1e-12);
    }
}

/// Four particles at a time: of several materials, and a last group that is not full.
TEST(StrainPass, every_particle_has_its_own_material) {
    Body body(particles::from_mesh(test::box_mesh(3)));
    ASSERT_EQ(body.particles.size() % 4, 2);
    body.solid.stiffness.push_back(2.5 * stiffness());
    body.solid.stiffness.push_back(material::Stiffness::Identity());
    for (std::size_t i = 0; i < body.solid.material.size(); ++i) body.solid.material[i] = static_cast<int>(i / 6 % 3);
    Fields fast, plain;
    StrainPass(body.particles, body.lists, body.solid).evaluate(body.displacement, fast);
    plain_strain_pass(body.particles, body.lists, body.solid, body.displacement, plain);
    EXPECT_LT(largest_difference(fast, plain), 1e-12);
}

TEST(StrainPass, sees_a_single_displacement) {
    Body body(stretched(1));
    StrainPass pass(body.particles, body.lists, body.solid);
    Fields before, after;
    pass.evaluate(body.displacement, before);
    const int moved = body.lists.of(100).back();
    body.displacement[moved].y() += 1e-6;
    pass.evaluate(body.displacement, after);
    for (int i = 0; i < body.particles.size(); ++i) {
        const auto list = body.lists.of(i);
        const bool concerned = i == moved || std::find(list.begin(), list.end(), moved) != list.end();
        EXPECT_EQ(after.gradient[i] != before.gradient[i], concerned) << i;
    }
}

TEST(StrainPass, particles_in_a_plane_take_the_pseudo_inverse) {
    std::vector<Eigen::Vector3d> places;
    for (int a = 0; a < 7; ++a)
        for (int b = 0; b < 7; ++b) places.emplace_back(0.1 * a, 0.1 * b, 0);
    const Body body(particles::from_points(places, std::vector<double>(places.size(), 1e-3), 0.1));
    StrainPass pass(body.particles, body.lists, body.solid);
    Fields fast;
    pass.evaluate(body.displacement, fast);
    EXPECT_EQ(pass.fallbacks(), body.particles.size());
    const StrainOperator op = make_strain_operator("corrected", body.particles, {body.lists, {}});
    EXPECT_LT(largest_difference(fast, evaluate(op, body.particles, body.solid, body.displacement)), 1e-12);
}

TEST(StrainPass, refuses_arrays_that_do_not_fit) {
    Body body(stretched(1));
    StrainPass pass(body.particles, body.lists, body.solid);
    Fields fields;
    body.displacement.pop_back();
    EXPECT_THROW(pass.evaluate(body.displacement, fields), std::invalid_argument);
    body.solid.material.pop_back();
    EXPECT_THROW(StrainPass(body.particles, body.lists, body.solid), std::invalid_argument);
}

}  // namespace
}  // namespace cleave::elasticity
