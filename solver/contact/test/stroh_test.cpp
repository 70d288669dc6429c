#include "solver/contact/half_space.hpp"
#include "solver/contact/indentation.hpp"
#include "solver/contact/stroh_field.hpp"
#include "solver/contact/test/field_checks.hpp"
#include "solver/material/material.hpp"
#include "solver/material/test/test_materials.hpp"

#include <gtest/gtest.h>

#include <random>

namespace cleave::contact {
namespace {

using Eigen::Vector3d;
using test::differentiated;

const HalfSpaceOptions by_stroh{.form = HalfSpaceForm::stroh};

material::Stiffness triclinic() {
    std::mt19937 generator(11);
    return material::test::random_triclinic(generator);
}

const std::vector<Vector3d> places{{0.5, 0.3, 0.7}, {-1.2, 0.4, 0.2}, {0, 0, 0.8}, {2, -1, 3}, {0.3, -0.2, 0.05}};

/// The stiffness is changed by 1e-8 of itself and the sum stops at 1e-7; slopes and shallow places amplify both.
TEST(Stroh, IsotropicLimitIsTheClosedForm) {
    const material::Stiffness glass = material::isotropic(70e9, 0.2);
    for (const double radius : {0.0, 0.6}) {
        const ContactLoad load{.inward = {0.6, 0, 0.8}, .force = {3, -2, 5}, .radius = radius};
        const HalfSpaceField closed = half_space_field(glass, load), sum = half_space_field(glass, load, by_stroh);
        const Eigen::Matrix3d axes = surface_axes(load.inward);
        for (const Vector3d& place : places) {
            const Vector3d x = axes * place;
            EXPECT_LT((sum.displacement(x) - closed.displacement(x)).norm(), 1e-6 * closed.displacement(x).norm()) << radius << " at " << place.transpose();
            EXPECT_LT((sum.stress(x) - closed.stress(x)).norm(), 1e-5 * closed.stress(x).norm()) << radius << " at " << place.transpose();
        }
    }
}

/// At the surface itself: cubic extrapolation from a depth of delta r / Im p (0.4 % of r here), and for a patch the midpoint rule across
/// the kinks at its rim.
TEST(Stroh, OnTheSurface) {
    const material::Stiffness glass = material::isotropic(70e9, 0.2);
    for (const double radius : {0.0, 0.6})
        for (const double z : {0.0, 1e-4, 2e-3}) {
            const ContactLoad load{.force = {3, -2, 5}, .radius = radius};
            const HalfSpaceField closed = half_space_field(glass, load), sum = half_space_field(glass, load, by_stroh);
            for (const Vector3d& x : {Vector3d(1, 0.5, z), Vector3d(-0.2, 0.1, z), Vector3d(40, -30, z)}) {
                EXPECT_LT((sum.displacement(x) - closed.displacement(x)).norm(), 1e-5 * closed.displacement(x).norm())
                    << radius << " at " << x.transpose();
            }
        }
}

TEST(Stroh, GradientIsTheDisplacementsDerivative) {
    for (const double radius : {0.0, 0.6}) {
        const HalfSpaceField field = half_space_field(triclinic(), {.force = {3, -2, 5}, .radius = radius}, {.accuracy = 1e-11});
        for (const Vector3d& x : places) {
            const Eigen::Matrix3d exact = field.gradient(x);
            EXPECT_LT((differentiated(field, x, 2e-3 * x[2]) - exact).norm(), 1e-6 * exact.norm()) << radius << " at " << x.transpose();
            EXPECT_LT(test::divergence(field, x, 1e-2 * x[2]), 1e-5) << radius << " at " << x.transpose();
        }
    }
}

/// In three attitudes: what nodes chosen adaptively are for. (Every material of the catalogue: the case contact_stroh.) 256 directions lose 15 % of the load below
/// a fibre that stands on the surface.
TEST(Stroh, TheForceGoesThrough) {
    const Vector3d force(3, -2, 5);
    std::mt19937 generator(6);
    const Eigen::Matrix3d turn = material::test::random_rotation(generator);
    for (const std::string name : {"soda-lime glass", "silicon", "T300/5208", "Sitka spruce"})
        for (const Vector3d& inward : {Vector3d(1, 0, 0), Vector3d(0, 0, 1), Vector3d(turn.col(1))})
            for (const double radius : {0.0, 0.6}) {
                const HalfSpaceField field = half_space_field(material::find_material(name).stiffness,
                                                              {.inward = inward, .force = force, .radius = radius}, {.form = HalfSpaceForm::stroh, .accuracy = 1e-5});
                EXPECT_LT((test::force_through_hemisphere(field, 1.7) - force).norm(), 1e-3 * force.norm()) << name << " " << inward.transpose() << " " << radius;
            }
}

/// The finest level against one twice as fine, at depths down to a hundredth.
TEST(Stroh, DirectionsFollowTheDepth) {
    const material::Stiffness c = material::find_material("T300/5208").stiffness;
    const auto table = std::make_shared<StrohTable>(c, 1024);
    const StrohField field(table, {.force = {0, 0, 1}}, 1e-7);
    EXPECT_LE(field.directions_at({0, 0, 1}), 256);
    EXPECT_GT(field.directions_at({1, 0, 0.1}), field.directions_at({1, 0, 0.5}));
    EXPECT_EQ(field.directions_at({1, 0, 0.001}), 1024);
}

/// An elliptical patch against its own point forces; beside a narrow rim 48 spokes leave some 1e-6.
TEST(Stroh, EllipseIsASumOfPointForces) {
    const material::Stiffness c = material::isotropic(70e9, 0.2);
    const double a = 1.3, b = 0.6;
    const Vector3d force(3, -2, 5), along(0.6, 0.8, 0), across(-0.8, 0.6, 0);
    const HalfSpaceField ellipse = half_space_field(c, {.force = force, .radius = a, .other_radius = b, .axis = along});
    const HalfSpaceField turned = half_space_field(c, {.force = force, .radius = a, .other_radius = b, .axis = across});
    for (const Vector3d& x : {Vector3d(0.5, 0.3, 0.7), Vector3d(-1.2, 0.4, 0.6), Vector3d(2, -1, 3)}) {
        const Vector3d sum = test::superposed(
            [&](const Vector3d& at, double share) { return half_space_field(c, {.point = at, .force = share * force}).displacement(x); }, a, b, along);
        EXPECT_LT((ellipse.displacement(x) - sum).norm(), 1e-5 * sum.norm());
        EXPECT_GT((turned.displacement(x) - sum).norm(), 1e-3 * sum.norm()) << "must fail twin";
    }
}

/// Vlassak and Nix (1993): 164.81, 172.81, 175.30 GPa; Willis (1966) in closed form where the axis of transverse isotropy is the normal.
TEST(Stroh, IndentationModulus) {
    const material::Stiffness silicon = material::find_material("silicon").stiffness;
    EXPECT_NEAR(indentation_modulus(silicon, {0, 0, 1}) * 1e-9, 164.81, 5e-3);
    EXPECT_NEAR(indentation_modulus(silicon, {1, 1, 0}) * 1e-9, 172.81, 5e-3);
    EXPECT_NEAR(indentation_modulus(silicon, {1, 1, 1}) * 1e-9, 175.30, 5e-3);
    material::Stiffness c = material::Stiffness::Zero();
    c.topLeftCorner<3, 3>() << 16, 7, 5, 7, 16, 5, 5, 5, 6;
    c.diagonal().tail<3>() << 2, 2, 4.5;
    const double willis = 2 * std::sqrt((16 * 6 - 25) / 16.0 / (1 / 2.0 + 2 / (std::sqrt(16.0 * 6) + 5)));
    EXPECT_NEAR(willis, 5.28639654, 5e-9);
    EXPECT_NEAR(indentation_modulus(c, {0, 0, 1}) / willis, 1, 1e-8);
    EXPECT_NEAR(indentation_modulus(material::isotropic(70e9, 0.2), {1, 2, 3}) / (70e9 / 0.96), 1, 1e-8);
}

}  // namespace
}  // namespace cleave::contact
