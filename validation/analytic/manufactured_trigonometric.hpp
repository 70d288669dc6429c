#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

/// Manufactured solution (Roache 2002): u_a = A_a sin(q_a . x / L + phi_a), each component with its own wave vector q_a (no
/// two parallel, none along an axis), so that every derivative of every component differs from zero somewhere.
/// body_force = -div sigma, in closed form: f_i = C_ijkl A_k q_k,l q_k,j / L^2 sin(q_k . x / L + phi_k).
/// |q_a| is 3.8 to 4.1: over `length` L (m) lies about two thirds of a wave. Amplitude `scale` times 1e-3 L.
Field manufactured_trigonometric(const Stiffness& stiffness, double length, double scale = 1);

}  // namespace cleave::analytic
