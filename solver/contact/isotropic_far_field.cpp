#include "solver/contact/isotropic_far_field.hpp"

#include <cmath>

namespace cleave::contact {

namespace {

using Lanes = Eigen::Array4d;

struct ComplexLanes {
    Lanes re, im;
};
ComplexLanes operator*(const ComplexLanes& a, const ComplexLanes& b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
ComplexLanes operator+(const ComplexLanes& a, const ComplexLanes& b) { return {a.re + b.re, a.im + b.im}; }

/// The derivatives of isotropic_half_space.cpp that displacements need, by 1/R and 1/v.
struct Derivatives {
    Lanes n2p, n2pp, n1p, n1pp, n0, n0p, below;
};

Derivatives of_centre(const Lanes& rho, const Lanes& z) {
    const Lanes R = (rho + z * z).sqrt(), r = 1 / R, v = 1 / (R + z), rv = r * v, r3 = r * r * r;
    return {-0.5 * v, 0.25 * rv * v, 0.5 * rv, -0.25 * r * rv * (r + v), r, -0.5 * r3, -z * r3};
}

/// Real parts of those of a source at the depth z + i s: the mean of the pair.
Derivatives of_pair(const Lanes& rho, const Lanes& z, double s) {
    const Lanes c = rho + z * z - s * s, d = 2 * s * z, size = (c * c + d * d).sqrt();  // R^2 = c + i d, c > 0
    const Lanes re = (0.5 * (size + c)).sqrt(), im = 0.5 * d / re, inverse = 1 / size;
    const ComplexLanes r{re * inverse, -im * inverse};
    const Lanes v_re = re + z, v_im = im + s, v_inverse = 1 / (v_re * v_re + v_im * v_im);
    const ComplexLanes v{v_re * v_inverse, -v_im * v_inverse};
    const ComplexLanes rv = r * v, rvv = rv * v, r2 = r * r, r3 = r2 * r, mixed = r * (rv * (r + v));
    return {-0.5 * v.re, 0.25 * rvv.re, 0.5 * rv.re, -0.25 * mixed.re, r.re, -0.5 * r3.re, -(z * r3.re - s * r3.im)};
}

Lanes mean(const Lanes& pair, const Lanes& centre) { return (7 * pair + 8 * centre) / 15; }

Derivatives of_patch(const Lanes& rho, const Lanes& z, double radius) {
    const Derivatives a = of_pair(rho, z, std::sqrt(3.0 / 7) * radius), b = of_centre(rho, z);
    return {mean(a.n2p, b.n2p), mean(a.n2pp, b.n2pp), mean(a.n1p, b.n1p), mean(a.n1pp, b.n1pp), mean(a.n0, b.n0), mean(a.n0p, b.n0p), mean(a.below, b.below)};
}

}  // namespace

bool is_far(const IsotropicContact& contact, const Eigen::Vector3d& position) {
    return contact.radius <= 0 || position.squaredNorm() > std::pow(far_radii * contact.radius, 2);
}

Eigen::Matrix<double, 3, 4> far_displacements(const IsotropicContact& contact, const Eigen::Matrix<double, 3, 4>& positions) {
    const Lanes x = positions.row(0), y = positions.row(1), z = positions.row(2).array().max(0.0), rho = x * x + y * y;
    const Derivatives n = contact.radius > 0 ? of_patch(rho, z, contact.radius) : of_centre(rho, z);
    const double nu = contact.poisson_ratio, fx = contact.force[0], fy = contact.force[1], fz = contact.force[2];
    const Lanes s = fx * x + fy * y;
    const Lanes q1 = 2 * s * n.n1p + fz * n.n0, q0 = 2 * s * n.n0p + fz * n.below;
    // u_t = (along f) f_t + (along t) t.
    const Lanes along_f = 2 * n.n0 + 4 * nu * n.n2p - 2 * z * n.n1p;
    const Lanes along_t = -2 * fz * n.n1p + 2 * nu * (4 * s * n.n2pp + 2 * fz * n.n1p) - z * (4 * s * n.n1pp + 2 * fz * n.n0p);
    Eigen::Matrix<double, 3, 4> u;
    u.row(0) = along_f * fx + along_t * x;
    u.row(1) = along_f * fy + along_t * y;
    u.row(2) = fz * n.n0 + (1 - 2 * nu) * q1 - z * q0;
    return u / (4 * M_PI * contact.shear_modulus);
}

}  // namespace cleave::contact
