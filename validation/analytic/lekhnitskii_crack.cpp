#include "validation/analytic/lekhnitskii_crack.hpp"

#include "validation/analytic/polynomial_roots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace cleave::analytic {

namespace {

using Complex = std::complex<double>;
using ComplexMatrix = std::array<std::array<Complex, 3>, 3>;
using Polynomial = std::vector<double>;  // ascending

/// Reduced compliances in units of 1/c_44-ish size, so that the polynomials are of order one. Index 0..5 for 1..6.
Stiffness reduced_compliance(const Stiffness& stiffness) {
    Stiffness s = invert(stiffness), reduced{};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) reduced[i][j] = s[i][j] - s[i][2] * s[j][2] / s[2][2];
    return reduced;
}

struct CharacteristicPolynomials {
    Polynomial l2, l3, l4;
    explicit CharacteristicPolynomials(const Stiffness& s)
        : l2{s[3][3], -2 * s[3][4], s[4][4]},
          l3{-s[1][3], s[1][4] + s[3][5], -(s[0][3] + s[4][5]), s[0][4]},
          l4{s[1][1], -2 * s[1][5], 2 * s[0][1] + s[5][5], -2 * s[0][5], s[0][0]} {}
    double coupling(double scale) const {
        double largest = 0;
        for (const double c : l3) largest = std::max(largest, std::abs(c));
        return largest / scale;
    }
    Polynomial sextic() const {
        Polynomial p(7, 0.0);
        for (std::size_t i = 0; i < l2.size(); ++i)
            for (std::size_t j = 0; j < l4.size(); ++j) p[i + j] += l2[i] * l4[j];
        for (std::size_t i = 0; i < l3.size(); ++i)
            for (std::size_t j = 0; j < l3.size(); ++j) p[i + j] -= l3[i] * l3[j];
        return p;
    }
};

Complex value(const Polynomial& p, Complex x) {
    Complex sum = 0;
    for (std::size_t power = p.size(); power-- > 0;) sum = sum * x + p[power];
    return sum;
}

double closest(const std::vector<Complex>& roots) {
    double least = INFINITY;
    for (std::size_t i = 0; i < roots.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, std::abs(roots[i] - roots[j]));
    return least;
}

/// The three roots; the last is the one of antiplane shear where the problem decouples.
std::vector<Complex> ordered_roots(const CharacteristicPolynomials& p, double scale) {
    if (p.coupling(scale) < 1e-10) {
        std::vector<Complex> roots = upper_roots(p.l4);
        roots.push_back(upper_roots(p.l2).at(0));
        return roots;
    }
    std::vector<Complex> roots = upper_roots(p.sextic());
    const auto antiplane = std::min_element(roots.begin(), roots.end(), [&](Complex a, Complex b) {
        return std::abs(value(p.l2, a)) < std::abs(value(p.l2, b));
    });
    if (antiplane != roots.end()) std::iter_swap(antiplane, roots.end() - 1);
    return roots;
}

ComplexMatrix inverse_of(const ComplexMatrix& m) {
    ComplexMatrix cofactor{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
            cofactor[j][i] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    const Complex determinant = m[0][0] * cofactor[0][0] + m[0][1] * cofactor[1][0] + m[0][2] * cofactor[2][0];
    for (auto& row : cofactor)
        for (Complex& entry : row) entry /= determinant;
    return cofactor;
}

/// Stress function b of a mode, and the displacement a whose strain the stress sigma_11 = -mu b1, sigma_22 = b2, sigma_12 = b1,
/// sigma_23 = b3, sigma_13 = -mu b3 makes: eps_11 = a1, gamma_13 = a3, gamma_12 = mu a1 + a2.
void set_mode(PlaneModes& modes, std::size_t mode, const std::array<Complex, 3>& b, const Stiffness& s) {
    const Complex mu = modes.mu[mode];
    const std::array<Complex, 6> stress{-mu * b[0], b[1], 0, b[2], -mu * b[2], b[0]};
    const auto strain = [&](std::size_t row) {
        Complex sum = 0;
        for (std::size_t j = 0; j < 6; ++j) sum += s[row][j] * stress[j];
        return sum;
    };
    const Complex a1 = strain(0), a3 = strain(4), a2 = strain(5) - mu * a1;
    const std::array<Complex, 3> a{a1, a2, a3};
    for (std::size_t i = 0; i < 3; ++i) modes.a[i][mode] = a[i], modes.b[i][mode] = b[i];
}

/// Re A <f> B^-1 t for the three functions of the modes.
Point combine(const ComplexMatrix& a, const std::array<Complex, 3>& f, const ComplexMatrix& b_inverse, const Point& t) {
    Point result{};
    for (std::size_t mode = 0; mode < 3; ++mode) {
        const Complex weight = f[mode] * (b_inverse[mode][0] * t[0] + b_inverse[mode][1] * t[1] + b_inverse[mode][2] * t[2]);
        for (std::size_t i = 0; i < 3; ++i) result[i] += (a[i][mode] * weight).real();
    }
    return result;
}

/// Displacement gradient of the far field that does not depend on x3: strain = s' sigma with eps_33 = 0.
Gradient far_gradient(const Stiffness& stiffness, const Point& t, const std::array<double, 2>& along) {
    const Stiffness s = reduced_compliance(stiffness);
    const Voigt stress{along[0], t[1], 0, t[2], along[1], t[0]};
    Voigt strain{};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) strain[i] += s[i][j] * stress[j];
    Gradient g{};
    g[0][0] = strain[0], g[1][1] = strain[1], g[0][1] = g[1][0] = strain[5] / 2;
    g[2][0] = strain[4], g[2][1] = strain[3];
    return g;
}

/// Displacement and gradient in crack axes.
class StraightCrack {
public:
    StraightCrack(const Stiffness& stiffness, double half_length, const Point& traction, const std::array<double, 2>& along)
        : modes_(plane_modes(stiffness)), far_(far_gradient(stiffness, traction, along)), a_(half_length), t_(traction) {}

    Point displacement(double x, double y) const {
        std::array<Complex, 3> f{};
        for (std::size_t k = 0; k < 3; ++k) f[k] = root(k, x, y) - (x + modes_.mu[k] * y);
        Point u = combine(modes_.a, f, modes_.b_inverse, t_);
        for (std::size_t i = 0; i < 3; ++i) u[i] += far_[i][0] * x + far_[i][1] * y;
        return u;
    }
    Gradient gradient(double x, double y) const {
        std::array<Complex, 3> slope{}, turned{};
        for (std::size_t k = 0; k < 3; ++k) {
            slope[k] = (x + modes_.mu[k] * y) / root(k, x, y) - 1.0;
            turned[k] = modes_.mu[k] * slope[k];
        }
        const Point first = combine(modes_.a, slope, modes_.b_inverse, t_), second = combine(modes_.a, turned, modes_.b_inverse, t_);
        Gradient g = far_;
        for (std::size_t i = 0; i < 3; ++i) g[i][0] += first[i], g[i][1] += second[i];
        return g;
    }

private:
    /// sqrt(z^2 - a^2) with its cut on the crack.
    Complex root(std::size_t k, double x, double y) const {
        const Complex z = x + modes_.mu[k] * y;
        return std::sqrt(z - a_) * std::sqrt(z + a_);
    }
    PlaneModes modes_;
    Gradient far_;
    double a_;
    Point t_;
};

}  // namespace

PlaneModes plane_modes(const Stiffness& stiffness) {
    Stiffness s = reduced_compliance(stiffness);
    const double scale = s[0][0];
    std::vector<Complex> mu = ordered_roots(CharacteristicPolynomials(s), scale);
    if (mu.size() == 3 && std::abs(mu[0] - mu[1]) < 1e-4 * std::abs(mu[0])) {
        s[5][5] *= 1 + 1e-6;
        mu = ordered_roots(CharacteristicPolynomials(s), scale);
    }
    if (mu.size() != 3 || std::abs(mu[0] - mu[1]) < 1e-5 * std::abs(mu[0])) throw std::invalid_argument("a material with three characteristic roots");
    const CharacteristicPolynomials p(s);
    PlaneModes modes;
    for (std::size_t k = 0; k < 3; ++k) modes.mu[k] = mu[k];
    const bool coupled = p.coupling(scale) >= 1e-10;
    if (coupled && closest(mu) < 1e-5 * std::abs(mu[0])) throw std::invalid_argument("a material whose characteristic roots differ");
    for (std::size_t k = 0; k < 2; ++k) {
        const Complex lambda = coupled ? -value(p.l3, mu[k]) / value(p.l2, mu[k]) : 0;
        set_mode(modes, k, {-mu[k], 1, -lambda}, s);
    }
    const Complex lambda = coupled ? -value(p.l3, mu[2]) / value(p.l4, mu[2]) : 0;
    set_mode(modes, 2, {-mu[2] * lambda, lambda, -1}, s);
    modes.b_inverse = inverse_of(modes.b);
    return modes;
}

Field straight_crack(const Stiffness& stiffness, const CrackAxes& axes, double half_length, const Point& traction,
                     const std::array<double, 2>& along) {
    const StraightCrack crack(in_axes(stiffness, axes), half_length, traction, along);
    const auto to_body = [axes](const Point& v) {
        Point result{};
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 3; ++i) result[i] += v[k] * axes[k][i];
        return result;
    };
    Field field;
    field.displacement = [=](const Point& x) { return to_body(crack.displacement(product(axes[0], x), product(axes[1], x))); };
    field.gradient = [=](const Point& x) {
        const Gradient local = crack.gradient(product(axes[0], x), product(axes[1], x));
        Gradient g{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                for (std::size_t p = 0; p < 3; ++p)
                    for (std::size_t q = 0; q < 3; ++q) g[i][j] += axes[p][i] * local[p][q] * axes[q][j];
        return g;
    };
    field.stress = [gradient = field.gradient, stiffness](const Point& x) { return stress_of(stiffness, gradient(x)); };
    field.source = "straight crack in an infinite plane (Stroh 1958, Lekhnitskii's stress functions)";
    return field;
}

AnisotropicHoop::AnisotropicHoop(const Stiffness& stiffness) {
    if (CharacteristicPolynomials p(reduced_compliance(stiffness)); p.coupling(p.l4.back()) >= 1e-8)
        throw std::invalid_argument("a material with the plane normal to the front as a plane of elastic symmetry");
    const PlaneModes modes = plane_modes(stiffness);
    mu1_ = modes.mu[0], mu2_ = modes.mu[1];
}

double AnisotropicHoop::operator()(double angle, double K_I, double K_II) const {
    const auto cube = [&](Complex mu) { return std::pow(std::sqrt(std::cos(angle) + mu * std::sin(angle)), 3); };
    const Complex h1 = cube(mu1_), h2 = cube(mu2_), apart = mu1_ - mu2_;
    return K_I * ((mu1_ * h2 - mu2_ * h1) / apart).real() + K_II * ((h2 - h1) / apart).real();
}

}  // namespace cleave::analytic
