#include "validation/analytic/barnett_lothe.hpp"
#include "validation/analytic/finite_width.hpp"
#include "validation/analytic/kink.hpp"
#include "validation/analytic/lekhnitskii_crack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::analytic {
namespace {

constexpr double degree = std::numbers::pi / 180;

Stiffness cubic(double c11, double c12, double c44) {
    Stiffness c{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) c[i][j] = i == j ? c11 : c12;
        c[i + 3][i + 3] = c44;
    }
    return c;
}

Stiffness silicon() { return cubic(165.7, 63.9, 79.6); }  // GPa

/// E = 200, nu = 0.3.
Stiffness isotropic() { return cubic(200 * 0.7 / (1.3 * 0.4), 200 * 0.3 / (1.3 * 0.4), 200 / 2.6); }

/// Material M of the fibre composites, fibre along x, GPa.
Stiffness composite() {
    Stiffness s{};
    const double E1 = 181, E2 = 10.3;
    s[0][0] = 1 / E1, s[1][1] = s[2][2] = 1 / E2;
    s[0][1] = s[1][0] = s[0][2] = s[2][0] = -0.28 / E1, s[1][2] = s[2][1] = -0.47 / E2;
    s[3][3] = 2 * 1.47 / E2, s[4][4] = s[5][5] = 1 / 7.17;
    return invert(s);
}

Stiffness triclinic() {
    const auto number = [](std::size_t row, std::size_t k) { return std::sin(1.0 + 3.0 * static_cast<double>(row) + 7.0 * static_cast<double>(k)); };
    Stiffness c{};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) {
            c[i][j] = i == j ? 60 : 0;
            for (std::size_t k = 0; k < 6; ++k) c[i][j] += 12 * number(i, k) * number(j, k);
        }
    return c;
}

Point cross(const Point& a, const Point& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
Point unit(const Point& a) {
    const double n = std::sqrt(product(a, a));
    return {a[0] / n, a[1] / n, a[2] / n};
}
CrackAxes axes(const Point& normal, const Point& front) { return {unit(cross(normal, front)), unit(normal), unit(front)}; }

/// L^-1 / 2 in crack axes.
Matrix half_inverse(const Stiffness& stiffness, const CrackAxes& frame) {
    Matrix m = inverse(barnett_lothe(in_axes(stiffness, frame), {0, 0, 1}));
    for (auto& row : m)
        for (double& entry : row) entry /= 2;
    return m;
}

TEST(BarnettLothe, IsotropicPlaneStrain) {
    const Matrix m = half_inverse(isotropic(), axes({1, 2, 3}, {3, 0, -1}));
    EXPECT_NEAR(m[0][0], 0.91 / 200, 1e-12);
    EXPECT_NEAR(m[1][1], 0.91 / 200, 1e-12);
    EXPECT_NEAR(m[2][2], 1.3 / 200, 1e-12);
    EXPECT_NEAR(m[0][1], 0, 1e-12);
}

// Published to six digits.
TEST(BarnettLothe, SiliconPlanes) {
    EXPECT_NEAR(half_inverse(silicon(), axes({1, 1, 1}, {1, -1, 0}))[1][1], 0.00568533, 1e-8);
    EXPECT_NEAR(half_inverse(silicon(), axes({1, 1, 0}, {0, 0, 1}))[1][1], 0.00614034, 1e-8);
    EXPECT_NEAR(half_inverse(silicon(), axes({1, 1, 0}, {1, -1, 0}))[1][1], 0.00553201, 1e-8);
    const Matrix coupled = half_inverse(silicon(), axes({1, 1, 1}, {1, 1, -2}));
    EXPECT_NEAR(coupled[0][0], 0.00583691, 1e-8);
    EXPECT_NEAR(coupled[1][1], 0.00572354, 1e-8);
    EXPECT_NEAR(coupled[2][2], 0.00785434, 1e-8);
    EXPECT_NEAR(std::abs(coupled[1][2]), 0.00043925, 1e-8);
}

// Sih, Paris and Irwin 1965, plane strain, through the compliances.
TEST(BarnettLothe, OrthotropicCracks) {
    const Matrix along = half_inverse(composite(), axes({0, 1, 0}, {0, 0, 1})), across = half_inverse(composite(), axes({1, 0, 0}, {0, 0, 1}));
    EXPECT_NEAR(along[1][1], 0.057644, 1e-6);
    EXPECT_NEAR(along[0][0], 0.0155441, 1e-7);
    EXPECT_NEAR(across[1][1], 0.0155441, 1e-7);
    EXPECT_NEAR(across[0][0], 0.057644, 1e-6);
}

// The two formalisms share no step: -Im(A B^-1) = L^-1, and the near field's closure work is k L^-1 k / 2.
TEST(PlaneModes, AgreeWithTheIntegralForm) {
    for (const Stiffness& c : {triclinic(), silicon(), composite(), isotropic()}) {
        const Stiffness turned = in_axes(c, axes({1, 1, 1}, {1, 1, -2}));
        const PlaneModes modes = plane_modes(turned);
        const Matrix expected = inverse(barnett_lothe(turned, {0, 0, 1}));
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                std::complex<double> sum = 0;
                for (std::size_t k = 0; k < 3; ++k) sum += modes.a[i][k] * modes.b_inverse[k][j];
                EXPECT_NEAR(-sum.imag(), expected[i][j], 2e-6 * expected[0][0]);  // isotropy is parted by 1e-6
            }
    }
}

TEST(StraightCrack, IsInBalanceFreeOnItsLipsAndOpensAtTheRate) {
    constexpr std::size_t voigt[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
    const CrackAxes frame = axes({1, 1, 1}, {1, 1, -2});
    const Point traction{0.3, 1, 0.4};
    const Field field = straight_crack(triclinic(), frame, 1, traction, {0.2, -0.1});
    const auto at = [&](double x, double y, double z) {
        Point p{};
        for (std::size_t i = 0; i < 3; ++i) p[i] = x * frame[0][i] + y * frame[1][i] + z * frame[2][i];
        return p;
    };
    const auto traction_at = [&](double x, double y) {  // on planes parallel to the crack, in crack axes
        const Voigt s = field.stress(at(x, y, 0));
        Point t{};
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j) t[k] += frame[k][i] * s[voigt[i][j]] * frame[1][j];
        return t;
    };
    const double step = 1e-4;
    for (const Point& x : {at(1.2, 0.3, 0), at(-0.4, -0.5, 1), at(-1.1, 0.1, 2)}) {
        const Gradient g = field.gradient(x);
        for (std::size_t j = 0; j < 3; ++j) {
            Point up = x, down = x;
            up[j] += step, down[j] -= step;
            const Point plus = field.displacement(up), minus = field.displacement(down);
            for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR((plus[i] - minus[i]) / (2 * step), g[i][j], 1e-7 * 0.1);
        }
        Point divergence{};
        for (std::size_t j = 0; j < 3; ++j) {
            Point up = x, down = x;
            up[j] += step, down[j] -= step;
            const Voigt plus = field.stress(up), minus = field.stress(down);
            for (std::size_t i = 0; i < 3; ++i) divergence[i] += (plus[voigt[i][j]] - minus[voigt[i][j]]) / (2 * step);
        }
        for (const double d : divergence) EXPECT_NEAR(d, 0, 1e-5);  // truncation of the difference, step^2 / r^3
    }
    const Point near = traction_at(1 + 1e-6, 0), lip = traction_at(0.3, 1e-9), far = traction_at(500, 300);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(near[k] * std::sqrt(2 * 1e-6), traction[k], 1e-5);  // K = t sqrt(pi a)
        EXPECT_NEAR(lip[k], 0, 1e-7);
        EXPECT_NEAR(far[k], traction[k], 1e-5);
    }
    EXPECT_NEAR(field.stress(at(500, 300, 0))[1], field.stress(at(-500, 300, 0))[1], 1e-4) << "no dislocation";
}

TEST(AnisotropicPenny, IsotropyGivesSneddonAndTheMeanIsTheMeanOfTheLocalRates) {
    const AnisotropicPenny penny(isotropic(), {0, 0, 1}, 2, {0, 0, 3});
    EXPECT_NEAR(penny.intensities(axes({0, 0, 1}, {0, 1, 0}))[1], 2 * 3 * std::sqrt(2 / std::numbers::pi), 1e-10);
    EXPECT_NEAR(penny.mean_energy_release(), 4 * 0.91 * 9 * 2 / (std::numbers::pi * 200), 1e-10);
    const Point normal = unit({1, -2, 2});
    const AnisotropicPenny any(triclinic(), normal, 2, {0.2, -0.5, 1});
    double mean = 0;
    constexpr int places = 90;
    const Point first = unit(cross(normal, {0, 0, 1})), second = cross(normal, first);
    for (int k = 0; k < places; ++k) {
        const double angle = 4 * 90 * degree * k / places;
        Point ahead{};
        for (std::size_t i = 0; i < 3; ++i) ahead[i] = std::cos(angle) * first[i] + std::sin(angle) * second[i];
        const CrackAxes place{ahead, normal, cross(ahead, normal)};
        mean += energy_release(triclinic(), place, any.intensities(place)) / places;
    }
    EXPECT_NEAR(mean / any.mean_energy_release(), 1, 1e-9);
}

// K_I of the disc a = b is 2 sigma sqrt(a/pi); Tada's centre crack at 0.5, edge crack at 0 and 0.5 (handbook tables, 0.5 %).
TEST(FiniteWidth, KnownValues) {
    EXPECT_NEAR(elliptical_crack_factor(2, 2, 0.7), 2 / std::numbers::pi, 1e-12);
    EXPECT_NEAR(centre_crack_factor(0.5), 1.1867, 0.005);
    EXPECT_NEAR(edge_crack_factor(0.5), 2.829, 0.02);
}

TEST(Kink, ErdoganAndSihAngles) {
    const double beta[] = {15, 30, 40, 45, 50, 60, 70, 75, 80};
    const double expected[] = {65.505, 60.000, 55.650, 53.130, 50.288, 43.221, 33.285, 26.740, 18.911};
    for (std::size_t i = 0; i < 9; ++i) {
        const double s = std::sin(beta[i] * degree), c = std::cos(beta[i] * degree);
        EXPECT_NEAR(hoop_kink_angle(s * s, s * c) / degree, -expected[i], 1e-3);
    }
    EXPECT_NEAR(hoop_kink_angle(0, 1) / degree, -70.529, 1e-3);
}

// A table of kinks tells sqrt(K_I^2 + 8 K_II^2), right, from sqrt(K_I^2 + K_II^2), a bug seen in a public code.
TEST(Kink, TheKnownBugWouldShow) {
    const double s = std::sin(30 * degree), c = std::cos(30 * degree);
    const double bug = 2 * std::atan((s * s - std::sqrt(s * s * s * s + s * c * s * c)) / (4 * s * c));
    EXPECT_GT(std::abs(bug - hoop_kink_angle(s * s, s * c)) / degree, 20);
}

TEST(Kink, EnergyAndSymmetry) {
    EXPECT_NEAR(energy_kink_angle(0, 1) / degree, -75.76, 0.01);
    EXPECT_NEAR(symmetry_kink_angle(0, 1) / degree, -77.33, 0.01);
    const double beta[] = {30, 45, 60, 75}, expected[] = {64.28, 56.57, 45.40, 27.35};
    for (std::size_t i = 0; i < 4; ++i) {
        const double s = std::sin(beta[i] * degree), c = std::cos(beta[i] * degree);
        EXPECT_NEAR(energy_kink_angle(s * s, s * c) / degree, -expected[i], 0.01);
    }
}

TEST(Kink, ACompositeStaysInItsWeakPlaneOnlyByToughness) {
    const AnisotropicHoop hoop(composite());
    EXPECT_NEAR(hoop(0, 2, 0), 2, 1e-9);
    EXPECT_NEAR(std::abs(anisotropic_kink_angle(hoop, 1, 0, {1, 0})) / degree, 45.5, 0.05);
    EXPECT_NEAR(anisotropic_kink_angle(hoop, 1, 0, {2, 0}) / degree, 0, 1e-4);
    EXPECT_NEAR(anisotropic_kink_angle(hoop, 1, 0, {1.65, 0}) / degree, 0, 1e-4);
    EXPECT_GT(std::abs(anisotropic_kink_angle(hoop, 1, 0, {1.63, 0})) / degree, 1);
    EXPECT_THROW((void)AnisotropicHoop{triclinic()}, std::invalid_argument);
}

TEST(Kink, IsotropicHoopIsErdoganAndSih) {
    const AnisotropicHoop hoop(isotropic());
    EXPECT_NEAR(anisotropic_kink_angle(hoop, 1, 0.7, {1, 0}), hoop_kink_angle(1, 0.7), 1e-5);
}

}  // namespace
}  // namespace cleave::analytic
