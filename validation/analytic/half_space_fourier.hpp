#pragma once

#include "validation/analytic/field.hpp"

#include <complex>
#include <map>
#include <vector>

namespace cleave::analytic {

using ComplexMatrix = std::array<std::array<std::complex<double>, 3>, 3>;

/// A half-space z >= 0 of any stiffness by Fourier transform over its surface: for waves exp(i k m.x) the surface impedance Z (traction
/// = k Z u) comes from the integrals of Barnett and Lothe (1973, Phys. Norv. 7, 13), and the interior decays like exp(k z M) with
/// M = -T^-1 (Z + i R^T). No eigenvalue problem anywhere.
class FourierHalfSpace {
public:
    /// `stiffness` in the axes of the surface (z into the body), Pa.
    explicit FourierHalfSpace(const Stiffness& stiffness);

    /// h = (L^-1)_zz of the direction phi, 1/Pa: P h / (2 pi r) is the normal displacement of the surface under a normal force P; h of the
    /// direction across r.
    double surface_compliance(double phi) const;

    /// 4 pi over the integral of h over a turn, Pa: P = 2 a M delta of a flat circular punch (Vlassak and Nix 1993, Phil. Mag. A 67, 1045).
    double indentation_modulus(int directions = 128) const;

    /// Integral of h m_a m_b over a turn, 1/Pa: p0/(4a) times it are the curvatures of the paraboloid under Hertz's pressure.
    std::array<std::array<double, 2>, 2> curvature_integral(int directions = 128) const;

    /// Gradient and displacement under a force (N) at the origin, spread like Hertz's pressure over `radius` (0: a point force), z > 0.
    /// The sums over directions and over the line loads that make up the pressure (Gauss's rule) are doubled until two agree to `tolerance`.
    struct Response {
        Point displacement;
        Gradient gradient;
    };
    Response response(const Point& force, double radius, const Point& at, double tolerance = 1e-8) const;

private:
    struct Direction {
        double cosine, sine;
        ComplexMatrix decay, compliance;  // M, Z^-1
    };
    Direction direction(double phi) const;
    const std::vector<Direction>& directions(int count) const;
    Response sum(const Point& force, double radius, const Point& at, int count) const;

    Stiffness stiffness_;
    mutable std::map<int, std::vector<Direction>> cache_;
};

}  // namespace cleave::analytic
