#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

enum class PlaneState { strain, stress };

/// Remote in-plane stress, Pa.
struct RemoteStress {
    double xx = 0;
    double yy = 0;
    double xy = 0;
};

/// Circular hole of radius `radius` (m) about the z axis in an infinite plate, any material with z = 0 as a plane of elastic
/// symmetry, under remote stress: Lekhnitskii's complex potentials (Lekhnitskii, Anisotropic Plates, 1968, ch. VI; Savin 1961).
/// Plane strain uses the reduced compliances a_ij - a_i3 a_j3 / a_33 (Lekhnitskii 1968, eq. 3.6), plane stress the a_ij.
/// The displacement has no rigid rotation; u_z = 0 (plane strain). Inside the hole the functions return NaN.
/// Throws std::invalid_argument where z = 0 is no plane of symmetry, or where the characteristic roots coincide
/// (isotropy in the plane; perturb the stiffness by 1e-6 then).
Field lekhnitskii_hole(const Stiffness& stiffness, double radius, const RemoteStress& remote, PlaneState state);

/// Stress concentration sigma_xx(0, a) / p under remote sigma_xx = p for axes along the orthotropy:
/// 1 + n, n^2 = 2 (sqrt(a22/a11) + a12/a11) + a66/a11 with the (reduced) compliances. Lekhnitskii 1968, eq. 43.4.
double hole_stress_concentration(const Stiffness& stiffness, PlaneState state);

}  // namespace cleave::analytic
