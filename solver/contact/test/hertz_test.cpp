#include "solver/contact/hertz.hpp"

#include "solver/contact/contact_area.hpp"
#include "solver/contact/indentation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace cleave::contact {
namespace {

/// A rigid sphere of 10 mm on a body of 70 GPa, nu 0.25, 1 kN.
TEST(Hertz, SphereOnAPlane) {
    const HertzContact contact = hertz_contact(1000, 10e-3, contact_modulus(70e9 / (1 - 0.0625), INFINITY));
    EXPECT_NEAR(contact.radius, 0.464849e-3, 5e-10);
    EXPECT_NEAR(contact.peak_pressure, 2.20962e9, 5e3);
    EXPECT_NEAR(contact.approach, 21.6084e-6, 5e-11);
    const HertzContact same = hertz_contact_of_approach(contact.approach, 10e-3, 70e9 / (1 - 0.0625));
    EXPECT_NEAR(same.force, 1000, 1e-9);
    EXPECT_NEAR(hertz_contact_area(contact), M_PI * contact.radius * contact.radius, 0);
}

TEST(Hertz, EllipseBecomesACircle) {
    const HertzContact circle = hertz_contact(1000, 10e-3, 75e9);
    for (const double excess : {0.0, 1e-8, 1e-6}) {
        const EllipticalContact ellipse = elliptical_contact(1000, 10e-3 * (1 + excess), 10e-3, 75e9);
        EXPECT_NEAR(ellipse.major / circle.radius, 1, 2 * excess + 1e-7);
        EXPECT_NEAR(ellipse.minor / circle.radius, 1, 2 * excess + 1e-7);
        EXPECT_NEAR(ellipse.peak_pressure / circle.peak_pressure, 1, 2 * excess + 1e-7);
        EXPECT_NEAR(ellipse.approach / circle.approach, 1, 2 * excess + 1e-7);
    }
}

/// Both of Johnson's Eqs. 4.26: with the half axes found, the deflection of the pressure must give both curvatures; here by integrals over
/// the half width, u = (p0 ab / 2E*) integral of (1 - x^2/(a^2+w) - y^2/(b^2+w)) dw / sqrt((a^2+w)(b^2+w)w), w = t^2.
TEST(Hertz, EllipseFitsBothCurvatures) {
    for (const double ratio : {1.01, 2.0, 10.0, 300.0}) {
        const double R1 = ratio * 10e-3, R2 = 10e-3, modulus = 75e9;
        const EllipticalContact c = elliptical_contact(1000, R1, R2, modulus);
        double along = 0, across = 0, middle = 0;
        const int steps = 4000;
        for (int i = 0; i < steps; ++i) {  // t = b tan(theta): smooth to both ends
            const double theta = M_PI / 2 * (i + 0.5) / steps, t = c.minor * std::tan(theta), w = t * t, dt = c.minor / std::pow(std::cos(theta), 2) * M_PI / 2 / steps;
            const double base = 2 * dt / std::sqrt((c.major * c.major + w) * (c.minor * c.minor + w));
            middle += base;
            along += base / (c.major * c.major + w);
            across += base / (c.minor * c.minor + w);
        }
        const double factor = c.peak_pressure * c.major * c.minor / (2 * modulus);
        EXPECT_NEAR(factor * middle / c.approach, 1, 1e-6) << ratio;
        EXPECT_NEAR(factor * along * 2 * R1, 1, 1e-6) << ratio;
        EXPECT_NEAR(factor * across * 2 * R2, 1, 1e-6) << ratio;
        EXPECT_NEAR(c.peak_pressure * 2 * M_PI / 3 * c.major * c.minor, 1000, 1e-9);
    }
}

/// The equation of motion m d^2x/dt^2 = -(4/3) E* sqrt(R) x^(3/2) in 20000 leapfrog steps.
TEST(Hertz, ImpactIsTheMotionOfAMassOnTheContact) {
    const double mass = 0.03, radius = 8e-3, modulus = 60e9, speed = 2.5;
    const Impact impact = hertz_impact(mass, radius, modulus, speed);
    const double stiffness = 4.0 / 3.0 * modulus * std::sqrt(radius), dt = impact.duration / 20000;
    double x = 0, v = speed, deepest = 0, time = 0;
    while (time == 0 || x > 0) {
        v -= 0.5 * dt * stiffness * std::pow(x, 1.5) / mass;
        x += dt * v;
        if (x > 0) v -= 0.5 * dt * stiffness * std::pow(x, 1.5) / mass;
        deepest = std::max(deepest, x);
        time += dt;
    }
    EXPECT_NEAR(impact.peak.approach / deepest, 1, 1e-6);
    EXPECT_NEAR(impact.duration / time, 1, 1e-3);
    EXPECT_NEAR(impact.peak.force / (stiffness * std::pow(deepest, 1.5)), 1, 1e-5);
    EXPECT_NEAR(impact.duration, 2.9432 * impact.peak.approach / speed, 1e-4 * impact.duration);
    const Impact same = hertz_impact_of_impulse(impact.impulse, mass, radius, modulus);
    EXPECT_NEAR(same.peak.force, impact.peak.force, 1e-9 * impact.peak.force);
}

TEST(Hertz, WhatIsNotAContactIsRejected) {
    EXPECT_THROW(hertz_contact(0, 1, 1), std::invalid_argument);
    EXPECT_THROW(hertz_contact(1, -1, 1), std::invalid_argument);
    EXPECT_THROW(hertz_impact(1, 1, 1, 0), std::invalid_argument);
    EXPECT_THROW(hertz_impact(0, 1, 1, 1), std::invalid_argument);
    EXPECT_THROW(elliptical_contact(1, 1, 2, 1), std::invalid_argument);
}

}  // namespace
}  // namespace cleave::contact
