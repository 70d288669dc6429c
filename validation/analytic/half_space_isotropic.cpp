#include "validation/analytic/half_space_isotropic.hpp"

#include "validation/analytic/gauss_rule.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::analytic {

using std::numbers::pi;

Point point_force_displacement(const IsotropicHalfSpace& load, const Point& at) {
    const double x = at[0], y = at[1], z = at[2], R = std::hypot(x, y, z), R3 = R * R * R, k = 1 - 2 * load.poisson_ratio;
    const double near = k / (R * (R + z)), nearer = near / (R + z);
    const auto [Qx, Qy, P] = load.force;
    const double ux = P * (x * z / R3 - near * x) + Qx * (1 / R + x * x / R3 + k / (R + z) - nearer * x * x) + Qy * (x * y / R3 - nearer * x * y);
    const double uy = P * (y * z / R3 - near * y) + Qy * (1 / R + y * y / R3 + k / (R + z) - nearer * y * y) + Qx * (x * y / R3 - nearer * x * y);
    const double uz = P * (z * z / R3 + 2 * (1 - load.poisson_ratio) / R) + (Qx * x + Qy * y) * (z / R3 + near);
    const double factor = 1 / (4 * pi * load.shear_modulus);
    return {factor * ux, factor * uy, factor * uz};
}

Point hertz_displacement_by_quadrature(const IsotropicHalfSpace& load, const Point& at, int rings) {
    const int spokes = 4 * rings;
    const double a = load.radius, b = load.other_radius > 0 ? load.other_radius : load.radius;
    Point sum{};
    for (const auto& [x, weight] : gauss_rule(rings)) {
        const double t = (1 + x) / 2, r = std::sqrt(1 - t * t), share = 3 * t * t * weight / 2 / spokes;
        for (int k = 0; k < spokes; ++k) {
            const double phi = 2 * pi * k / spokes;
            const Point u = point_force_displacement(load, {at[0] - a * r * std::cos(phi), at[1] - b * r * std::sin(phi), at[2]});
            for (std::size_t i = 0; i < 3; ++i) sum[i] += share * u[i];
        }
    }
    return sum;
}

HertzInterior hertz_interior(const IsotropicHalfSpace& load, const Point& at) {
    if (load.force[0] != 0 || load.force[1] != 0) throw std::invalid_argument("a force along the normal");
    const double a = load.radius, p0 = 1.5 * load.force[2] / (pi * a * a), nu = load.poisson_ratio, G = load.shear_modulus;
    // The formulas are 0/0 on the surface and on the axis, where they lose (a/r)^2 of their digits and the fields are even in r,
    // u_r and tau_rz odd: a step of 1e-9 a off the one and of 1e-4 a off the other.
    const double z = std::max(at[2], 1e-9 * a), distance = std::hypot(at[0], at[1]), r = std::max(distance, 1e-4 * a), odd = distance / r;
    // m^2 is the larger root's square; for b < 0 in the form that does not cancel.
    const double b = r * r + z * z - a * a, d = std::sqrt(b * b + 4 * a * a * z * z);
    const double m = std::sqrt(b < 0 ? 2 * a * a * z * z / (d - b) : (b + d) / 2);
    const double q = a * a + m * m, c = z / m, A = std::atan2(a, m);
    const double I2 = (A - a * m / q) / (a * a * a);
    // Potentials of the pressure: psi = int p/R, psi1 = int p ln(R + z); derivatives by r and z. psi_zz = -2 pi p0 d(c - zA/a)/dz follows
    // from Laplace's equation, psi_rz from psi_z.
    const double psi = pi * p0 * a * a / 2 * (2 * A / a - r * r * I2 - 2 * z * c / (a * a) + 2 * z * z * A / (a * a * a));
    const double psi_r = -pi * p0 * a * a * r * I2, psi_z = -2 * pi * p0 * (c - z * A / a);
    const double psi1_r = pi * p0 * r / a * (2 * a * a * a * (1 - c * c * c) / (3 * r * r) - z * (A - a * m / q));
    const double psi1_rr = -psi1_r / r - psi_z;
    // dm/dz and dm/dr from r^2/(a^2 + m^2) + z^2/m^2 = 1; c = z/m.
    const double slope = m * m * m * m * r * r / (q * q) + z * z, m_z = z * m / slope, m_r = m * m * m * r / (q * slope);
    const double c_z = r * r * m * m_z / (q * q * c), c_r = (r * r * m * m_r / (q * q) - r / q) / c;
    const double A_z = -a / q * m_z, A_r = -a / q * m_r;
    const double psi_zz = -2 * pi * p0 * (c_z - A / a - z * A_z / a), psi_rz = -2 * pi * p0 * (c_r - z * A_r / a);
    const double psi_rr = -psi_r / r - psi_zz;
    const double sz = (psi_z - z * psi_zz) / (2 * pi), trz = -odd * z * psi_rz / (2 * pi);
    const double sr = (2 * nu * psi_z - z * psi_rr - (1 - 2 * nu) * psi1_rr) / (2 * pi);
    const double st = (2 * nu * psi_z - z * psi_r / r - (1 - 2 * nu) * psi1_r / r) / (2 * pi);
    const double ur = -odd * ((1 - 2 * nu) * psi1_r + z * psi_r) / (4 * pi * G), uz = (2 * (1 - nu) * psi - z * psi_z) / (4 * pi * G);
    const double phi = std::atan2(at[1], at[0]), x = std::cos(phi), y = std::sin(phi);
    return {{ur * x, ur * y, uz}, {sr * x * x + st * y * y, sr * y * y + st * x * x, sz, trz * y, trz * x, (sr - st) * x * y}};
}

}  // namespace cleave::analytic
