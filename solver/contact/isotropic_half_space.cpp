#include "solver/contact/isotropic_half_space.hpp"

#include "solver/contact/isotropic_far_field.hpp"

#include <array>
#include <cmath>
#include <complex>

// Displacements of a loaded half-space by potentials (Love 1929; Johnson 1985, Eqs. 3.2 to 3.8). Let n2 = z ln(R+z) - R, and n_k its
// further z-derivatives (k falling: n1 = ln(R+z), n0 = 1/R) and integrals (k rising). For a point force f, with q_k = f . (d/dx, d/dy, d/dz) n_k,
//
//   4 pi G u_t = 2 f_t n0 - f_z grad_t n1 + 2 nu grad_t q2 - z grad_t q1
//   4 pi G u_z = f_z n0 + (1 - 2 nu) q1 - z q0
//
// Every n_k depends on z and rho = x^2 + y^2; primes are derivatives by rho. A pressure like sqrt(1 - r^2/a^2) is a superposition of point
// sources at imaginary depths: n_k becomes 3/(4a^3) times the integral of (a^2 - s^2) n_k(rho, z + i s) over s from -a to a. Two
// integrations by parts give it in closed form, with zeta = z + i a:
//
//   n_k -> (3/a^3) [ Im n_{k+3}(zeta) - a Re n_{k+2}(zeta) ]
//
// Only real coefficients multiply the n_k, so this holds for displacements and gradients alike, with the real z where z stands by itself.

namespace cleave::contact {

namespace {

/// The derivatives that u and its gradient need, of n2, n1, n0, n-1 (`below`), n-2: p is ', pp is '', ppp is '''.
struct Derivatives {
    double n2p, n2pp, n1p, n1pp, n0, n0p, below;
    double n2ppp = 0, n1ppp = 0, n0pp = 0, belowp = 0, below2 = 0;  // of the gradient only
};

using Complex = std::complex<double>;

double root(double square) { return std::sqrt(square); }

/// The root with a positive real part, for squares with an imaginary part of at least zero; half the cost of std::sqrt.
Complex root(const Complex& square) {
    const double c = square.real(), d = square.imag(), size = std::sqrt(c * c + d * d);
    if (c >= 0) {
        const double re = std::sqrt(0.5 * (size + c));
        return {re, re > 0 ? 0.5 * d / re : 0};
    }
    const double im = std::sqrt(0.5 * (size - c));
    return {0.5 * d / im, im};
}

/// n_k and their rho-derivatives at (rho, z): R = sqrt(rho + z^2), v = R + z, L = ln v. Each was integrated by z and checked by
/// differentiation; the constants make each harmonic (4 rho n'' + 4 n' = -n_{k-2}).
template <typename Scalar>
struct Source {
    Scalar z, R, v, L{};
    double rho;

    Source(double rho_, Scalar z_, bool with_logarithm) : z(z_), R(root(rho_ + z * z)), v(R + z), rho(rho_) {
        using std::log;
        if (with_logarithm) L = log(v);
    }

    Scalar n5p() const { return -0.25 * (z * (R * R + R * z + z * z) / (12.0 * v) - 0.625 * z * R - 0.25 * z * z + (0.5 * z * z - 0.125 * rho) * L); }
    Scalar n5pp() const { return L / 32.0 + (R + 5.0 * z) / (64.0 * v) - z * (R + 2.0 * z) / (96.0 * v * v); }
    Scalar n5ppp() const { return (3.0 * R + z) / (192.0 * v * v * v); }
    Scalar n4p() const { return -0.25 * ((R * R + R * z + z * z) / (3.0 * v) + z * L - R - 0.5 * z); }
    Scalar n4pp() const { return (2.0 * R + z) / (24.0 * v * v); }
    Scalar n4ppp() const { return -1.0 / (24.0 * v * v * v); }
    Scalar n3() const { return (0.5 * z * z - 0.25 * rho) * L - 0.75 * z * R + 0.25 * rho; }
    Scalar n3p() const { return -0.25 * L + (R - z) / (8.0 * v); }
    Scalar n3pp() const { return -1.0 / (8.0 * v * v); }
    Scalar n3ppp() const { return 1.0 / (8.0 * R * v * v * v); }
    Scalar n2() const { return z * L - R; }
    Scalar n2p() const { return -0.5 / v; }
    Scalar n2pp() const { return 0.25 / (R * v * v); }
    Scalar n2ppp() const { return -(v + 2.0 * R) / (8.0 * R * R * R * v * v * v); }
    Scalar n1() const { return L; }
    Scalar n1p() const { return 0.5 / (R * v); }
    Scalar n1pp() const { return -0.25 * (v + R) / (R * R * R * v * v); }
    Scalar n1ppp() const { return (3.0 * v * v + 3.0 * R * v + 2.0 * R * R) / (8.0 * R * R * R * R * R * v * v * v); }
    Scalar n0() const { return 1.0 / R; }
    Scalar n0p() const { return -0.5 / (R * R * R); }
    Scalar n0pp() const { return 0.75 / (R * R * R * R * R); }
    Scalar below() const { return -z / (R * R * R); }
    Scalar belowp() const { return 1.5 * z / (R * R * R * R * R); }
    Scalar below2() const { return (2.0 * z * z - rho) / (R * R * R * R * R); }
};

double real_part(double value) { return value; }
double real_part(const Complex& value) { return value.real(); }

/// Of one source, real or complex; the real part then stands for the source and its mirror image at the conjugate depth.
template <typename Scalar>
Derivatives of_source(double rho, Scalar z, bool gradient) {
    const Source<Scalar> s(rho, z, false);
    Derivatives d{real_part(s.n2p()), real_part(s.n2pp()), real_part(s.n1p()), real_part(s.n1pp()),
                  real_part(s.n0()),  real_part(s.n0p()),  real_part(s.below())};
    if (!gradient) return d;
    d.n2ppp = real_part(s.n2ppp());
    d.n1ppp = real_part(s.n1ppp());
    d.n0pp = real_part(s.n0pp());
    d.belowp = real_part(s.belowp());
    d.below2 = real_part(s.below2());
    return d;
}

/// Of Hertz's pressure on the unit circle.
Derivatives of_unit_circle(double rho, double z, bool gradient) {
    const Source<Complex> s(rho, Complex(z, 1), true);
    const auto closed = [](const Complex& third, const Complex& second) { return 3 * (third.imag() - second.real()); };
    const Complex n4p = s.n4p(), n4pp = s.n4pp(), n3p = s.n3p(), n2 = s.n2();
    Derivatives d{closed(s.n5p(), n4p), closed(s.n5pp(), n4pp), closed(n4p, n3p), closed(n4pp, s.n3pp()),
                  closed(s.n3(), n2),   closed(n3p, s.n2p()),   closed(n2, s.n1())};
    if (!gradient) return d;
    d.n2ppp = closed(s.n5ppp(), s.n4ppp());
    d.n1ppp = closed(s.n4ppp(), s.n3ppp());
    d.n0pp = closed(s.n3pp(), s.n2pp());
    d.belowp = closed(s.n2p(), s.n1p());
    d.below2 = closed(s.n1(), s.n0());
    return d;
}

/// Far off: isotropic_far_field.hpp says which sources.
Derivatives of_three_sources(double rho, double z, bool gradient) {
    const Derivatives pair = of_source(rho, Complex(z, std::sqrt(3.0 / 7)), gradient), one = of_source(rho, z, gradient);
    const auto mean = [](double of_pair, double of_one) { return (7 * of_pair + 8 * of_one) / 15; };
    return {mean(pair.n2p, one.n2p),       mean(pair.n2pp, one.n2pp),     mean(pair.n1p, one.n1p),   mean(pair.n1pp, one.n1pp),
            mean(pair.n0, one.n0),         mean(pair.n0p, one.n0p),       mean(pair.below, one.below), mean(pair.n2ppp, one.n2ppp),
            mean(pair.n1ppp, one.n1ppp),   mean(pair.n0pp, one.n0pp),     mean(pair.belowp, one.belowp), mean(pair.below2, one.below2)};
}

/// A place with its lengths in units of `length`, on or below the surface.
struct Place {
    double length, x, y, z;
    Derivatives n;
};

Place place(const IsotropicContact& contact, const Eigen::Vector3d& position, bool gradient) {
    const double a = contact.radius > 0 ? contact.radius : position.norm();
    const double x = position[0] / a, y = position[1] / a, z = std::max(position[2] / a, 0.0), rho = x * x + y * y;
    if (contact.radius <= 0) return {a, x, y, z, of_source(rho, z, gradient)};
    if (is_far(contact, position)) return {a, x, y, z, of_three_sources(rho, z, gradient)};
    // On the circle itself 1/R is singular, and multiplied by z = 0: step inside.
    const double least = 1e-12;
    return {a, x, y, z, of_unit_circle(rho, std::max(z, std::abs(rho - 1) < least ? least : 0.0), gradient)};
}

/// u at a near place, in closed form.
Eigen::Vector3d near_displacement(const IsotropicContact& contact, const Eigen::Vector3d& position) {
    const auto [length, x, y, z, n] = place(contact, position, false);
    const double nu = contact.poisson_ratio, fz = contact.force[2];
    const Eigen::Vector2d t(x, y), f = contact.force.head<2>();
    const double s = f.dot(t);
    const double q1 = 2 * s * n.n1p + fz * n.n0, q0 = 2 * s * n.n0p + fz * n.below;
    const Eigen::Vector2d grad_q2 = 2 * n.n2p * f + (4 * s * n.n2pp + 2 * fz * n.n1p) * t;
    const Eigen::Vector2d grad_q1 = 2 * n.n1p * f + (4 * s * n.n1pp + 2 * fz * n.n0p) * t;
    Eigen::Vector3d u;
    u.head<2>() = 2 * n.n0 * f - 2 * fz * n.n1p * t + 2 * nu * grad_q2 - z * grad_q1;
    u[2] = fz * n.n0 + (1 - 2 * nu) * q1 - z * q0;
    return u / (4 * M_PI * contact.shear_modulus * length);
}

}  // namespace

void isotropic_displacements(const IsotropicContact& contact, std::span<const Eigen::Vector3d> positions, std::span<Eigen::Vector3d> displacement) {
    constexpr int lanes = 4;
    Eigen::Matrix<double, 3, lanes> x;
    std::array<std::size_t, lanes> at;
    int filled = 0;
    const auto flush = [&] {
        for (int k = filled; k < lanes; ++k) x.col(k) = x.col(0);
        const Eigen::Matrix<double, 3, lanes> u = far_displacements(contact, x);
        for (int k = 0; k < filled; ++k) displacement[at[k]] = u.col(k);
        filled = 0;
    };
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!is_far(contact, positions[i])) {
            displacement[i] = near_displacement(contact, positions[i]);
            continue;
        }
        x.col(filled) = positions[i];
        at[filled++] = i;
        if (filled == lanes) flush();
    }
    if (filled > 0) flush();
}

Eigen::Vector3d isotropic_displacement(const IsotropicContact& contact, const Eigen::Vector3d& position) {
    Eigen::Vector3d u;
    isotropic_displacements(contact, {&position, 1}, {&u, 1});
    return u;
}

Eigen::Matrix3d isotropic_gradient(const IsotropicContact& contact, const Eigen::Vector3d& position) {
    const auto [length, x, y, z, n] = place(contact, position, true);
    const double nu = contact.poisson_ratio, fz = contact.force[2];
    const Eigen::Vector2d t(x, y), f = contact.force.head<2>();
    const double s = f.dot(t);
    const double q0 = 2 * s * n.n0p + fz * n.below, below_q = 2 * s * n.belowp + fz * n.below2;
    const Eigen::Vector2d grad_q1 = 2 * n.n1p * f + (4 * s * n.n1pp + 2 * fz * n.n0p) * t;
    const Eigen::Vector2d grad_q0 = 2 * n.n0p * f + (4 * s * n.n0pp + 2 * fz * n.belowp) * t;
    const Eigen::Matrix2d tt = t * t.transpose(), ft = f * t.transpose(), one = Eigen::Matrix2d::Identity();
    const auto second = [&](double npp, double nppp, double lowerp, double lowerpp) -> Eigen::Matrix2d {
        return 4 * npp * (ft + ft.transpose() + s * one) + 8 * s * nppp * tt + fz * (2 * lowerp * one + 4 * lowerpp * tt);
    };
    Eigen::Matrix3d g;
    g.topLeftCorner<2, 2>() = 4 * n.n0p * ft - 2 * fz * (n.n1p * one + 2 * n.n1pp * tt) +
                              2 * nu * second(n.n2pp, n.n2ppp, n.n1p, n.n1pp) - z * second(n.n1pp, n.n1ppp, n.n0p, n.n0pp);
    g.topRightCorner<2, 1>() = 2 * n.below * f - 2 * fz * n.n0p * t + (2 * nu - 1) * grad_q1 - z * grad_q0;
    g.bottomLeftCorner<1, 2>() = (2 * fz * n.n0p * t + (1 - 2 * nu) * grad_q1 - z * grad_q0).transpose();
    g(2, 2) = fz * n.below - 2 * nu * q0 - z * below_q;
    return g / (4 * M_PI * contact.shear_modulus * length * length);
}

}  // namespace cleave::contact
