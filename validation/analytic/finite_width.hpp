#pragma once

namespace cleave::analytic {

/// K_I / (sigma sqrt(pi a)) of a plate under tension across its crack, `ratio` = a / W; the elastic constants do not matter (Tada, Paris
/// and Irwin 2000, The Stress Analysis of Cracks Handbook).
/// Centre crack of length 2a in a plate of width 2W: (1 - 0.025 alpha^2 + 0.06 alpha^4) sqrt(sec(pi alpha / 2)), 0.1 %.
double centre_crack_factor(double ratio);
/// Edge crack of length a in a plate of width W whose ends may turn: 1.12 - 0.231 alpha + 10.55 alpha^2 - 21.72 alpha^3 + 30.39 alpha^4,
/// 0.5 % up to alpha = 0.6.
double edge_crack_factor(double ratio);

/// K_I / (sigma sqrt(pi b)) of an elliptical crack of half axes a >= b in infinite space under tension normal to it, at the place
/// (a cos phi, b sin phi) of its front: (sin^2 phi + (b/a)^2 cos^2 phi)^(1/4) / E(k), k^2 = 1 - b^2/a^2 (Irwin 1962, J. Appl. Mech. 29, 651;
/// isotropic).
double elliptical_crack_factor(double a, double b, double phi);

}  // namespace cleave::analytic
