#include "reference_fem/kinked_crack.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace cleave::fem {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

/// Muskhelishvili's potentials at a point z: Phi, Phi' there and Omega at conj(z); stresses are
///   sigma_xx + sigma_yy = 2 (Phi + conj Phi),  sigma_yy - i sigma_xy = Phi + Omega(conj z) + (z - conj z) conj(Phi').
struct Potentials {
    Complex phi, slope, omega_below;
};

Potentials operator+(const Potentials& a, const Potentials& b) { return {a.phi + b.phi, a.slope + b.slope, a.omega_below + b.omega_below}; }

/// sigma_tt + i sigma_rt on the ray of direction e = exp(i angle).
Complex traction(const Potentials& p, Complex z, Complex e) {
    return p.phi + std::conj(p.phi) + e * e * ((std::conj(z) - z) * p.slope - p.phi + std::conj(p.omega_below));
}

/// The singular field of the crack along x < 0: Phi = Omega = (K_I - i K_II) / (2 sqrt(2 pi z)).
Potentials tip_field(Complex k, Complex z) {
    const Complex phi = k / (2.0 * std::sqrt(2 * pi * z));
    return {phi, -phi / (2.0 * z), k / (2.0 * std::sqrt(2 * pi * std::conj(z)))};
}

struct Value {
    Complex value, slope;
};

/// Phi1 = Omega1 = -1/2 (1 - X(z)/X(a)) / (z - a), X = z^-1/2: with X changing its sign across the crack, the sum over both lips is -1/(x - a).
Value reflected(Complex a, Complex z) {
    const Complex x = 1.0 / std::sqrt(z), ratio = x * std::sqrt(a), d = z - a;
    return {-0.5 * (1.0 - ratio) / d, -0.5 * (0.5 * ratio / z / d - (1.0 - ratio) / (d * d))};
}

/// Its derivative over a: for -1/(x - a)^2.
Value reflected_twice(Complex a, Complex z) {
    const Complex x = 1.0 / std::sqrt(z), root = std::sqrt(a), ratio = x * root, q = -0.5 / root, d = z - a;
    const Complex value = (1.0 - ratio) / (d * d) + x * q / d;
    const Complex slope = 0.5 * ratio / z / (d * d) - 2.0 * (1.0 - ratio) / (d * d * d) - 0.5 * x / z * q / d - x * q / (d * d);
    return {-0.5 * value, -0.5 * slope};
}

/// A dislocation of strength A at z0 beside the crack, whose lips stay free: in the infinite plane Phi = A / (z - z0) and
/// Omega = A / (z - conj z0) + conj A (z0 - conj z0) / (z - conj z0)^2, and the reflected fields take Phi + Omega from the lips.
Potentials dislocation(Complex strength, Complex z0, Complex z) {
    const Complex mirror = std::conj(z0), doubled = std::conj(strength) * (z0 - mirror), below = std::conj(z);
    const Potentials plane{strength / (z - z0), -strength / ((z - z0) * (z - z0)), strength / (below - mirror) + doubled / ((below - mirror) * (below - mirror))};
    const auto lips = [&](Complex at) {
        const Value first = reflected(z0, at), second = reflected(mirror, at), twice = reflected_twice(mirror, at);
        return Value{strength * (first.value + second.value) + doubled * twice.value, strength * (first.slope + second.slope) + doubled * twice.slope};
    };
    const Value here = lips(z);
    return plane + Potentials{here.value, here.slope, lips(below).value};
}

/// Place on the kink of length one of u in [-1, 1], denser at the corner, where the density is singular weaker than at the tip.
double place(double u) { return (1 + u) * (1 + u) / 4; }

}  // namespace

/// With A dt = g du / sqrt(1 - u^2): Gauss and Chebyshev's rule of n nodes, tractions vanish at n - 1 points between them (Erdogan and Gupta
/// 1972, Q. Appl. Math. 29, 525), g vanishes at the corner. At the tip A = g(1) / sqrt(2 (1 - t)), and a density a / sqrt(1 - t) makes
/// K'_I + i K'_II = (2 pi)^3/2 conj(a) e there; g at the ends by Krenk's sum (1975, Q. Appl. Math. 33, 225).
KinkFactors kink_factors(double angle) {
    constexpr int n = 40;
    const Complex e = std::polar(1.0, angle);
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    Eigen::MatrixXd load = Eigen::MatrixXd::Zero(2 * n, 2);
    const std::array<Complex, 2> unit{Complex(1, 0), Complex(0, 1)};
    for (int row = 1; row < n; ++row) {
        const Complex z = place(std::cos(pi * row / n)) * e;
        const auto put = [&](Eigen::MatrixXd& to, int column, Complex value) {
            to(row - 1, column) = value.real();
            to(n - 1 + row - 1, column) = value.imag();
        };
        for (int k = 0; k < n; ++k)
            for (int part = 0; part < 2; ++part) {
                const Complex z0 = place(std::cos((2 * k + 1) * pi / (2 * n))) * e;
                put(system, 2 * k + part, pi / n * traction(dislocation(unit[part], z0, z), z, e));
            }
        put(load, 0, -traction(tip_field(1, z), z, e));
        put(load, 1, -traction(tip_field({0, -1}, z), z, e));
    }
    Eigen::VectorXd end(n);
    for (int k = 0; k < n; ++k) end[k] = std::sin((2 * k + 1) * (2 * n - 1) * pi / (4 * n)) / std::sin((2 * k + 1) * pi / (4 * n)) / n;
    for (int k = 0; k < n; ++k) system(2 * n - 2, 2 * k) = system(2 * n - 1, 2 * k + 1) = end[n - 1 - k];

    const Eigen::MatrixXd g = system.partialPivLu().solve(load);
    KinkFactors factors{};
    for (int mode = 0; mode < 2; ++mode) {
        Complex tip = 0;
        for (int k = 0; k < n; ++k) tip += end[k] * Complex(g(2 * k, mode), g(2 * k + 1, mode));
        const Complex intensity = std::pow(2 * pi, 1.5) * std::conj(tip / std::sqrt(2.0)) * e;
        factors[0][mode] = intensity.real();
        factors[1][mode] = intensity.imag();
    }
    return factors;
}

double energy_kink_angle(const Stiffness& stiffness, const Intensities& k) {
    (void)near_tip(stiffness, TipForm::isotropic);  // refuses anisotropy
    const auto release = [&](double angle) {
        const KinkFactors f = kink_factors(angle);
        const double opening = f[0][0] * k[1] + f[0][1] * k[0], sliding = f[1][0] * k[1] + f[1][1] * k[0];
        return opening > 0 ? opening * opening + sliding * sliding : 0;
    };
    constexpr double step = 5 * pi / 180;
    double best = 0, most = release(0);
    for (int n = 1; n <= 17; ++n)
        for (const double angle : {n * step, -n * step})
            if (const double here = release(angle); here > most * (1 + 1e-9)) most = here, best = angle;
    double low = best - step, high = best + step;
    const double golden = (std::sqrt(5.0) - 1) / 2;
    while (high - low > 1e-6) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        if (release(left) > release(right))
            high = right;
        else
            low = left;
    }
    return (low + high) / 2;
}

}  // namespace cleave::fem
