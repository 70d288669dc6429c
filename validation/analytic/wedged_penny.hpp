#pragma once

namespace cleave::analytic {

/// Energy release rate (J/m^2) of a penny crack of radius a (m) in an infinite isotropic solid whose lips a force P (N) pushes apart,
/// spread evenly over the disc r < c < a: K = (2/sqrt(pi a)) integral of r p / sqrt(a^2 - r^2) over the disc (Sneddon 1946), which is
/// (2 p / sqrt(pi a)) (a - sqrt(a^2 - c^2)), p = P / (pi c^2), and tends to P / (pi a)^(3/2); G = K^2 (1 - nu^2) / E.
double wedged_penny_release(double young, double poisson, double force, double load_radius, double crack_radius);

}  // namespace cleave::analytic
