#include "solver/contact/half_space.hpp"

#include "solver/contact/hertz.hpp"
#include "solver/contact/test/field_checks.hpp"
#include "solver/material/test/test_materials.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace cleave::contact {
namespace {

using Eigen::Vector3d;
using test::differentiated;

constexpr double young = 70e9, nu = 0.25, shear = young / (2 * (1 + nu));
const material::Stiffness glass = material::isotropic(young, nu);

const std::vector<Vector3d> places{{0.5, 0.3, 0.7}, {-1.2, 0.4, 0.2}, {0, 0, 0.8}, {2, -1, 3}, {0.9, 0.1, 0.01}, {-30, 50, 20}, {0.3, -0.2, 0.05}};

/// Boussinesq and Cerruti as printed (Johnson 1985, Eqs. 3.18, 3.75), P along z, Q along x.
Vector3d printed_point_force(double P, double Q, const Vector3d& at) {
    const double x = at[0], y = at[1], z = at[2], R = at.norm(), k = 1 - 2 * nu;
    const Vector3d normal(x * z / std::pow(R, 3) - k * x / (R * (R + z)), y * z / std::pow(R, 3) - k * y / (R * (R + z)),
                          z * z / std::pow(R, 3) + 2 * (1 - nu) / R);
    const Vector3d tangential(1 / R + x * x / std::pow(R, 3) + k * (1 / (R + z) - x * x / (R * std::pow(R + z, 2))),
                              x * y / std::pow(R, 3) - k * x * y / (R * std::pow(R + z, 2)), x * z / std::pow(R, 3) + k * x / (R * (R + z)));
    return (P * normal + Q * tangential) / (4 * M_PI * shear);
}

TEST(HalfSpace, PointForceIsBoussinesqAndCerruti) {
    const HalfSpaceField field = half_space_field(glass, {.inward = {0, 0, 1}, .force = {3, 0, 5}});
    const Eigen::Matrix3d axes = surface_axes({0, 0, 1});
    EXPECT_EQ(axes, Eigen::Matrix3d::Identity());
    for (const Vector3d& x : places) {
        const Vector3d printed = printed_point_force(5, 3, x);
        EXPECT_LT((field.displacement(x) - printed).norm(), 1e-14 * printed.norm());
        EXPECT_GT((field.displacement(x) - printed_point_force(5, -3, x)).norm(), 1e-3 * printed.norm()) << "must fail twin";
    }
}

/// The sum converges like the smoothness of the integrand: at depths of a quarter of the radius 16 rings and 48 spokes leave below 1e-6.
TEST(HalfSpace, HertzPressureIsASumOfPointForces) {
    const Vector3d force(3, -2, 5);
    const HalfSpaceField field = half_space_field(glass, {.force = force, .radius = 1.3});
    for (const Vector3d& x : {Vector3d(0.5, 0.3, 0.7), Vector3d(-1.2, 0.4, 0.5), Vector3d(2, -1, 3), Vector3d(0, 0, 0.5)}) {
        const auto point = [&](const Vector3d& at, double share) {
            return half_space_field(glass, {.point = at, .force = share * force}).displacement(x);
        };
        const Vector3d sum = test::superposed(point, 1.3, 1.3, Vector3d::UnitX());
        EXPECT_LT((field.displacement(x) - sum).norm(), 1e-6 * sum.norm()) << x.transpose();
        EXPECT_GT((field.displacement(x) - test::superposed(point, 1.2, 1.2, Vector3d::UnitX())).norm(), 1e-3 * sum.norm()) << "must fail twin";
    }
}

TEST(HalfSpace, ClosedFormsAreNotAwareOfAxes) {
    std::mt19937 generator(4);
    const Eigen::Matrix3d turn = material::test::random_rotation(generator);
    const Vector3d at(0.2, -1, 0.4), force(3, 1, 5), offset(7, 8, 9);
    const HalfSpaceField plain = half_space_field(glass, {.force = force, .radius = 0.7});
    const HalfSpaceField turned = half_space_field(glass, {.point = offset, .inward = turn.col(2), .force = turn * force, .radius = 0.7});
    EXPECT_LT((turned.displacement(offset + turn * at) - turn * plain.displacement(at)).norm(), 1e-13 * plain.displacement(at).norm());
    const Eigen::Matrix3d stress = material::stress_from_voigt(plain.stress(at));
    EXPECT_LT((material::stress_from_voigt(turned.stress(offset + turn * at)) - turn * stress * turn.transpose()).norm(), 1e-12 * stress.norm());
}

/// Fourth order differences with steps of 1e-3 of the distance to the nearest singularity: truncation 1e-11, rounding 1e-12.
TEST(HalfSpace, GradientIsTheDisplacementsDerivative) {
    for (const double radius : {0.0, 0.6}) {
        const HalfSpaceField field = half_space_field(glass, {.force = {3, -2, 5}, .radius = radius});
        for (const Vector3d& x : places) {
            const Eigen::Matrix3d exact = field.gradient(x);
            EXPECT_LT((differentiated(field, x, 1e-3 * x[2]) - exact).norm(), 1e-6 * exact.norm()) << radius << " at " << x.transpose();
            EXPECT_LT(test::divergence(field, x, 1e-2 * x[2]), 1e-6) << radius << " at " << x.transpose();
        }
    }
}

/// From 8 radii on a simpler form takes over; gradients lose a factor of 10 by their derivatives.
TEST(HalfSpace, FormsOfTheFarFieldMeet) {
    const HalfSpaceField patch = half_space_field(glass, {.force = {3, -2, 5}, .radius = 0.01});
    const HalfSpaceField point = half_space_field(glass, {.force = {3, -2, 5}});
    const Vector3d direction(0.48, 0.36, 0.8), inner = 0.08 * (1 - 1e-12) * direction, outer = 0.08 * (1 + 1e-12) * direction;
    EXPECT_LT((patch.displacement(inner) - patch.displacement(outer)).norm(), 1e-7 * patch.displacement(inner).norm());
    EXPECT_LT((patch.gradient(inner) - patch.gradient(outer)).norm(), 1e-6 * patch.gradient(inner).norm());
    EXPECT_GT((patch.displacement(inner) - point.displacement(inner)).norm(), 1e-5 * patch.displacement(inner).norm()) << "must fail twin";
    const Vector3d far = 2 * direction;
    EXPECT_LT((patch.displacement(far) - point.displacement(far)).norm(), 1e-5 * point.displacement(far).norm());
}

/// Far and near places mixed, a number that four does not divide.
TEST(HalfSpace, ManyAtOnceAreTheSameBits) {
    for (const double radius : {0.0, 0.1}) {
        const HalfSpaceField field = half_space_field(glass, {.inward = {0.6, 0, 0.8}, .force = {3, -2, 5}, .radius = radius});
        std::vector<Vector3d> values(places.size());
        field.displacements(places, values);
        for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(values[i], field.displacement(places[i])) << i;
    }
}

/// Johnson (1985), Sect. 3.4: pressure on the surface, tension (1 - 2 nu) p0/3 at the rim, shear 0.310 p0 at a depth of 0.478 a (nu 0.3).
TEST(HalfSpace, HertzStressesOfTheBook) {
    const HertzContact hertz = hertz_contact(1000, 10e-3, young / (1 - nu * nu));
    const HalfSpaceField field = half_space_field(glass, {.force = {0, 0, hertz.force}, .radius = hertz.radius});
    for (const double r : {0.0, 0.3, 0.8}) {
        const material::Voigt stress = field.stress({r * hertz.radius, 0, 0});
        EXPECT_NEAR(stress[2] / hertz.peak_pressure, -std::sqrt(1 - r * r), 1e-9);
        EXPECT_NEAR(stress[4] / hertz.peak_pressure, 0, 1e-9);
    }
    const material::Voigt rim = field.stress({1.000001 * hertz.radius, 0, 0});
    EXPECT_NEAR(rim[0] / hertz_edge_tension(hertz, nu), 1, 1e-5);
    EXPECT_NEAR(hertz_edge_tension(hertz, nu), 368.27e6, 5e3);
    const HalfSpaceField steel = half_space_field(material::isotropic(200e9, 0.3), {.force = {0, 0, 2 * M_PI / 3}, .radius = 1});
    const auto shear_at = [&](double depth) {
        const material::Voigt s = steel.stress({0, 0, depth});
        return 0.5 * (s[0] - s[2]);
    };
    EXPECT_NEAR(shear_at(0.481), 0.310, 5e-4);
    EXPECT_GT(shear_at(0.481), shear_at(0.44));
    EXPECT_GT(shear_at(0.481), shear_at(0.52));
    EXPECT_NEAR(steel.displacement({0, 0, 0})[2], M_PI * (1 - 0.09) / (2 * 200e9), 1e-9 * 1e-11);  // pi p0 a / 2E*, p0 = 1, a = 1
}

TEST(HalfSpace, TheForceGoesThrough) {
    const Vector3d force(3, -2, 5);
    for (const double radius : {0.0, 0.6}) {
        const HalfSpaceField field = half_space_field(glass, {.point = {1, 2, 3}, .inward = {0.6, 0, 0.8}, .force = force, .radius = radius});
        EXPECT_LT((test::force_through_hemisphere(field, 1.7) - force).norm(), 1e-6 * force.norm());
    }
}

TEST(HalfSpace, OutsideCountsAsTheSurfaceBelow) {
    const HalfSpaceField field = half_space_field(glass, {.force = {0, 0, 5}, .radius = 0.1});
    EXPECT_EQ(field.displacement({1, 2, -0.3}), field.displacement({1, 2, 0}));
}

TEST(HalfSpace, WhatIsNotAContactIsRejected) {
    std::mt19937 generator(4);
    EXPECT_THROW(HalfSpace(material::test::random_triclinic(generator), {0, 0, 1}, {.form = HalfSpaceForm::closed}), std::invalid_argument);
    EXPECT_THROW(HalfSpace(glass, {0, 0, 0}), std::invalid_argument);
    const auto half_space = std::make_shared<HalfSpace>(glass, Vector3d(0, 0, 1));
    EXPECT_THROW(HalfSpaceField(half_space, {.inward = {0, 0.1, 1}}), std::invalid_argument);
    EXPECT_THROW(half_space_field(glass, {.force = {0, 0, 1}, .radius = 1, .other_radius = 0.5}), std::invalid_argument) << "no axis";
}

}  // namespace
}  // namespace cleave::contact
