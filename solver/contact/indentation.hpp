#pragma once

#include "solver/contact/half_space.hpp"

namespace cleave::contact {

/// h(phi) = n . Re(i A B^-1) . n of the direction m = cos(phi) t1 + sin(phi) t2, t1 and t2 of surface_axes(): the normal displacement
/// of the surface under a normal point force P at distance r is P h / (2 pi r), h of the direction across r (1/Pa). 2 (1 - nu^2)/E where
/// isotropic.
double surface_compliance(const HalfSpace& half_space, double phi);

/// Indentation modulus M = 4 pi / (integral of h over a turn), Pa: P = 2 a M delta for a flat circular punch on any material (Willis
/// 1966; Vlassak and Nix 1993). E/(1 - nu^2) where isotropic. The mean over a turn converges exponentially in `directions`.
double indentation_modulus(const HalfSpace& half_space, int directions = 256);

/// The same for a normal of any material.
double indentation_modulus(const material::Stiffness& stiffness, const Eigen::Vector3d& inward, int directions = 256);

/// Contact modulus of two bodies (Pa): 1/E* = 1/M1 + 1/M2. A rigid one has an infinite M.
double contact_modulus(double first, double second);

}  // namespace cleave::contact
