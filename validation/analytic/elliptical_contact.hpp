#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

/// Hertz's pressure p0 sqrt(1 - x^2/a^2 - y^2/b^2) on an ellipse, half axes a along x and b along y (m), p0 (Pa).
struct EllipticalPressure {
    double a, b, peak;
};

/// Normal displacement (m) of the surface at (x, y) inside the ellipse; `modulus` is E/(1 - nu^2) (Pa), of both bodies together for their
/// approach. Boussinesq's 1/rho summed over the ellipse in polar coordinates about the place: along a chord the pressure is a half ellipse,
/// whose area is known, and what is left is a periodic integral over half a turn. No elliptic integral, no potential of an ellipsoid.
double surface_displacement(const EllipticalPressure& pressure, double modulus, double x, double y, int directions = 256);

/// The pressure's resultant (N) by Gauss's rule along the chords through the centre.
double resultant(const EllipticalPressure& pressure);

}  // namespace cleave::analytic
