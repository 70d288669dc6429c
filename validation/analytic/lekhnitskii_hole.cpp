#include "validation/analytic/lekhnitskii_hole.hpp"

#include "validation/analytic/polynomial_roots.hpp"

#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>

namespace cleave::analytic {

namespace {

using Complex = std::complex<double>;
using Plane = std::array<std::array<double, 3>, 3>;  // indices 1, 2, 6 of the compliance

constexpr std::array<std::size_t, 3> in_plane{0, 1, 5};

Plane plane_compliance(const Stiffness& stiffness, PlaneState state) {
    const Stiffness a = invert(stiffness);
    Plane reduced{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            reduced[i][j] = a[in_plane[i]][in_plane[j]];
            if (state == PlaneState::strain) reduced[i][j] -= a[in_plane[i]][2] * a[2][in_plane[j]] / a[2][2];
        }
    return reduced;
}

void require_plane_of_symmetry(const Stiffness& c) {
    for (const std::size_t i : {0U, 1U, 2U, 5U})
        for (const std::size_t j : {3U, 4U})
            if (std::abs(c[i][j]) > 1e-9 * c[0][0])
                throw std::invalid_argument("a material with z = 0 as a plane of elastic symmetry (C_i4 = C_i5 = 0)");
}

/// Roots with Im > 0 of a11 m^4 - 2 a16 m^3 + (2 a12 + a66) m^2 - 2 a26 m + a22 = 0.
std::array<Complex, 2> characteristic_roots(const Plane& a) {
    const auto upper = upper_roots({a[1][1], -2 * a[1][2], 2 * a[0][1] + a[2][2], -2 * a[0][2], a[0][0]});
    if (upper.size() != 2 || std::abs(upper[0] - upper[1]) < 1e-4 * std::abs(upper[0]))
        throw std::invalid_argument("a material whose characteristic roots differ (isotropy in the plane: perturb C by 1e-6)");
    return {upper[0], upper[1]};
}

/// The potentials Phi_k = A_k / zeta_k with z_k = x + mu_k y = (a/2) [(1 - i mu_k) zeta_k + (1 + i mu_k) / zeta_k].
/// The hole is free where dF/dx and dF/dy of the stress function are constant on it; with the remote field
/// dF0/dx = s_yy x - s_xy y, dF0/dy = s_xx y - s_xy x this gives, from the e^{-i theta} terms,
/// A_1 + A_2 = a (-s_yy + i s_xy) / 2 and mu_1 A_1 + mu_2 A_2 = a (s_xy - i s_xx) / 2.
class HolePotentials {
public:
    HolePotentials(const Plane& compliance, double radius, const RemoteStress& remote)
        : a_(compliance), radius_(radius), remote_(remote), mu_(characteristic_roots(compliance)) {
        const Complex sum = radius / 2 * Complex(-remote.yy, remote.xy);
        const Complex weighted = radius / 2 * Complex(remote.xy, -remote.xx);
        A_[0] = (weighted - mu_[1] * sum) / (mu_[0] - mu_[1]);
        A_[1] = sum - A_[0];
    }

    /// sigma_xx, sigma_yy, sigma_xy.
    std::array<double, 3> stress(double x, double y) const {
        std::array<double, 3> s{remote_.xx, remote_.yy, remote_.xy};
        for (std::size_t k = 0; k < 2; ++k) {
            const Complex zeta = map(k, x, y);
            const Complex slope = radius_ / 2 * (left(k) - right(k) / (zeta * zeta));  // dz_k / dzeta
            const Complex derivative = -A_[k] / (zeta * zeta) / slope;                 // dPhi_k / dz_k
            s[0] += 2 * (mu_[k] * mu_[k] * derivative).real();
            s[1] += 2 * derivative.real();
            s[2] -= 2 * (mu_[k] * derivative).real();
        }
        return s;
    }

    std::array<double, 2> displacement(double x, double y) const {
        const auto strain = contract({remote_.xx, remote_.yy, remote_.xy});
        std::array<double, 2> u{strain[0] * x + strain[2] / 2 * y, strain[1] * y + strain[2] / 2 * x};
        for (std::size_t k = 0; k < 2; ++k) {
            const Complex potential = A_[k] / map(k, x, y);
            const Complex m = mu_[k];
            u[0] += 2 * ((a_[0][0] * m * m + a_[0][1] - a_[0][2] * m) * potential).real();
            u[1] += 2 * ((a_[0][1] * m + a_[1][1] / m - a_[1][2]) * potential).real();
        }
        return u;
    }

    /// In-plane strain (xx, yy, engineering xy) of an in-plane stress.
    std::array<double, 3> contract(const std::array<double, 3>& s) const {
        std::array<double, 3> e{};
        for (std::size_t i = 0; i < 3; ++i) e[i] = a_[i][0] * s[0] + a_[i][1] * s[1] + a_[i][2] * s[2];
        return e;
    }

private:
    Complex left(std::size_t k) const { return 1.0 - Complex(0, 1) * mu_[k]; }
    Complex right(std::size_t k) const { return 1.0 + Complex(0, 1) * mu_[k]; }

    /// The root outside the unit circle.
    Complex map(std::size_t k, double x, double y) const {
        const Complex z = (x + mu_[k] * y) / radius_;
        const Complex root = std::sqrt(z * z - left(k) * right(k));
        const Complex one = (z + root) / left(k), two = (z - root) / left(k);
        return std::abs(one) >= std::abs(two) ? one : two;
    }

    Plane a_;
    double radius_;
    RemoteStress remote_;
    std::array<Complex, 2> mu_;
    std::array<Complex, 2> A_{};
};

}  // namespace

Field lekhnitskii_hole(const Stiffness& stiffness, double radius, const RemoteStress& remote, PlaneState state) {
    require_plane_of_symmetry(stiffness);
    const HolePotentials potentials(plane_compliance(stiffness, state), radius, remote);
    const Stiffness full = invert(stiffness);
    const auto outside = [radius](const Point& x) { return std::hypot(x[0], x[1]) >= radius * (1 - 1e-12); };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Field field;
    field.displacement = [=](const Point& x) {
        if (!outside(x)) return Point{nan, nan, nan};
        const auto u = potentials.displacement(x[0], x[1]);
        return Point{u[0], u[1], 0};
    };
    field.stress = [=](const Point& x) {
        if (!outside(x)) return Voigt{nan, nan, nan, nan, nan, nan};
        const auto s = potentials.stress(x[0], x[1]);
        const double zz = state == PlaneState::stress ? 0 : -(full[2][0] * s[0] + full[2][1] * s[1] + full[2][5] * s[2]) / full[2][2];
        return Voigt{s[0], s[1], zz, 0, 0, s[2]};
    };
    field.gradient = [=](const Point& x) {
        // The rotation is not part of the stress solution: central differences of the displacement give it.
        const double step = 1e-5 * radius;
        Gradient g{};
        for (std::size_t b = 0; b < 2; ++b) {
            Point up = x, down = x;
            up[b] += step;
            down[b] -= step;
            const auto plus = potentials.displacement(up[0], up[1]), minus = potentials.displacement(down[0], down[1]);
            for (std::size_t i = 0; i < 2; ++i) g[i][b] = (plus[i] - minus[i]) / (2 * step);
        }
        return g;
    };
    field.source = state == PlaneState::strain ? "Lekhnitskii 1968, plane strain (reduced compliances)" : "Lekhnitskii 1968, plane stress";
    return field;
}

double hole_stress_concentration(const Stiffness& stiffness, PlaneState state) {
    require_plane_of_symmetry(stiffness);
    const Plane a = plane_compliance(stiffness, state);
    // On the hole at (0, a): sigma_xx = p (1 + n) with n = sqrt(2 (sqrt(a22/a11) + a12/a11) + a66/a11).
    return 1 + std::sqrt(2 * (std::sqrt(a[1][1] / a[0][0]) + a[0][1] / a[0][0]) + a[2][2] / a[0][0]);
}

}  // namespace cleave::analytic
