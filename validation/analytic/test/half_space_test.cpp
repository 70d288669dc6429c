#include "validation/analytic/elliptical_contact.hpp"
#include "validation/analytic/half_space_fourier.hpp"
#include "validation/analytic/half_space_isotropic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cleave::analytic {
namespace {

constexpr double young = 70, poisson = 0.25, shear = young / (2 * (1 + poisson));

Stiffness isotropic() {
    const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
    Stiffness c{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) c[i][j] = lambda;
        c[i][i] += 2 * shear;
        c[i + 3][i + 3] = shear;
    }
    return c;
}

/// C11, C33, C13, C12, C44 = 16, 6, 5, 7, 2 about z.
Stiffness transversely_isotropic() {
    Stiffness c{};
    c[0][0] = c[1][1] = 16, c[2][2] = 6, c[0][1] = c[1][0] = 7, c[0][2] = c[2][0] = c[1][2] = c[2][1] = 5;
    c[3][3] = c[4][4] = 2, c[5][5] = 4.5;
    return c;
}

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }
double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }

const std::vector<Point> places{{0.5, 0.3, 0.7}, {-1.2, 0.4, 0.5}, {0, 0, 0.8}, {2, -1, 3}};

/// Two forms of one solution: Boussinesq summed over the circle, and the book's elementary functions.
TEST(HalfSpace, HertzByQuadratureAndByPotentials) {
    const IsotropicHalfSpace load{shear, poisson, {0, 0, 5}, 1.3};
    for (const Point& x : places) {
        const Point u = hertz_interior(load, x).displacement;
        EXPECT_LT(distance(hertz_displacement_by_quadrature(load, x), u), 1e-8 * length(u));
    }
    EXPECT_THROW(hertz_interior({shear, poisson, {1, 0, 5}, 1.3}, {0, 0, 1}), std::invalid_argument);
}

/// An ellipse by chords: a circle is the book's paraboloid p0 pi (2 a^2 - r^2)/(4 a E*); below an ellipse's surface the sum over rings comes
/// up to it like the depth.
TEST(HalfSpace, EllipticalPressureByChordsAndByRings) {
    const double modulus = young / (1 - poisson * poisson), pi = std::numbers::pi;
    EXPECT_NEAR(surface_displacement({1.3, 1.3, 2}, modulus, 0.5, -0.4), 2 * pi / (4 * 1.3 * modulus) * (2 * 1.69 - 0.41), 1e-14);
    const EllipticalPressure ellipse{1.3, 0.6, 2};
    EXPECT_NEAR(resultant(ellipse), 2.0 / 3 * 2 * pi * 1.3 * 0.6, 1e-13);
    const auto below = [&](double z) {
        return hertz_displacement_by_quadrature({shear, poisson, {0, 0, resultant(ellipse)}, 1.3, 0.6}, {0.4, -0.2, z}, 192)[2];
    };
    // u falls by (1 - 2 nu)/(2 G) p z at first; fourth order extrapolation of 0.05, 0.1, ... leaves about 1e-4.
    const double risen = 4 * below(0.05) - 6 * below(0.1) + 4 * below(0.15) - below(0.2), u = surface_displacement(ellipse, modulus, 0.4, -0.2);
    EXPECT_NEAR(risen / u, 1, 1e-3);
    EXPECT_GT(std::abs(risen / surface_displacement({0.6, 1.3, 2}, modulus, 0.4, -0.2) - 1), 1e-2) << "must fail twin";
    EXPECT_THROW(surface_displacement(ellipse, modulus, 0, 0.7), std::invalid_argument);
}

TEST(HalfSpace, HertzStressesOfTheBook) {
    const double p0 = 1, a = 1;
    const IsotropicHalfSpace load{shear, 0.3, {0, 0, 2 * std::numbers::pi / 3}, a};
    EXPECT_NEAR(hertz_interior(load, {0.6, 0, 0}).stress[2], -0.8 * p0, 1e-8);
    EXPECT_NEAR(hertz_interior(load, {1 + 1e-7, 0, 0}).stress[0], (1 - 2 * 0.3) * p0 / 3, 1e-3);  // rises like a square root
    const Voigt deep = hertz_interior(load, {0, 0, 0.481}).stress;
    EXPECT_NEAR((deep[0] - deep[2]) / 2, 0.310, 5e-4);
}

/// The stress is that of the displacement: central differences, steps of 1e-4.
TEST(HalfSpace, HertzStressBelongsToTheDisplacement) {
    const IsotropicHalfSpace load{shear, poisson, {0, 0, 5}, 1.3};
    for (const Point& x : places) {
        Gradient g{};
        for (std::size_t b = 0; b < 3; ++b) {
            Point up = x, down = x;
            up[b] += 1e-4, down[b] -= 1e-4;
            const Point u = hertz_interior(load, up).displacement, v = hertz_interior(load, down).displacement;
            for (std::size_t i = 0; i < 3; ++i) g[i][b] = (u[i] - v[i]) / 2e-4;
        }
        const Voigt differentiated = stress_of(isotropic(), g), stated = hertz_interior(load, x).stress;
        for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(differentiated[k], stated[k], 1e-6);
    }
}

TEST(HalfSpace, FourierAgreesWithBoussinesqAndHertz) {
    const FourierHalfSpace half_space(isotropic());
    const IsotropicHalfSpace point{shear, poisson, {3, -2, 5}}, hertz{shear, poisson, {0, 0, 5}, 1.3};
    for (const Point& x : places) {
        const Point u = point_force_displacement(point, x);
        EXPECT_LT(distance(half_space.response(point.force, 0, x).displacement, u), 1e-8 * length(u));
        const HertzInterior interior = hertz_interior(hertz, x);
        const auto response = half_space.response(hertz.force, hertz.radius, x);
        EXPECT_LT(distance(response.displacement, interior.displacement), 1e-8 * length(interior.displacement));
        const Voigt stress = stress_of(isotropic(), response.gradient);
        for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(stress[k], interior.stress[k], 1e-7);
    }
    EXPECT_THROW(half_space.response({0, 0, 1}, 0, {1, 0, 0}), std::invalid_argument);
}

/// Willis (1966): 2 sqrt([(C11 C33 - C13^2)/C11] / [1/C44 + 2/(sqrt(C11 C33) + C13)]) = 5.28639654.
TEST(HalfSpace, IndentationModulusByBarnettAndLothe) {
    EXPECT_NEAR(FourierHalfSpace(transversely_isotropic()).indentation_modulus(), 5.28639654, 5e-9);
    EXPECT_NEAR(FourierHalfSpace(isotropic()).indentation_modulus(), young / (1 - poisson * poisson), 1e-9);
    const auto curvature = FourierHalfSpace(transversely_isotropic()).curvature_integral();
    EXPECT_NEAR(curvature[0][0], curvature[1][1], 1e-12);
    EXPECT_NEAR(curvature[0][1], 0, 1e-12);
}

}  // namespace
}  // namespace cleave::analytic
