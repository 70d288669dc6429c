#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

/// Load on an isotropic half-space z >= 0 at the origin: a force (N, z into the body), as a point force (radius 0) or as Hertz's pressure
/// on a circle of `radius` (m), or on an ellipse of half axes `radius` along x and `other_radius` along y.
struct IsotropicHalfSpace {
    double shear_modulus;  ///< Pa
    double poisson_ratio;
    Point force;
    double radius = 0;
    double other_radius = 0;  ///< 0: a circle
};

/// Boussinesq and Cerruti as printed (Johnson 1985, Contact Mechanics, Eqs. 3.18 and 3.75), m.
Point point_force_displacement(const IsotropicHalfSpace& load, const Point& at);

/// Hertz's pressure by the same, summed over the circle or ellipse: rings by Gauss's rule in sqrt(1 - r^2/a^2), equal steps of angle. Any
/// direction of the force. Good where the depth is a fair part of a ring's spacing: `rings` 64 gives 1e-8 at a depth of a/4.
Point hertz_displacement_by_quadrature(const IsotropicHalfSpace& load, const Point& at, int rings = 64);

/// Displacement and stress under Hertz's pressure along z in real elementary functions (Love 1929, Phil. Trans. R. Soc. A 228; Johnson 1985,
/// Sect. 3.4; the closed forms of the potentials after Huber 1904). Tangential parts of the force must be zero.
struct HertzInterior {
    Point displacement;  ///< m
    Voigt stress;        ///< Pa
};
HertzInterior hertz_interior(const IsotropicHalfSpace& load, const Point& at);

}  // namespace cleave::analytic
