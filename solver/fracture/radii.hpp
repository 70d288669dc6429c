#pragma once

#include <functional>

namespace cleave::fracture {

/// Weight of the contact area in Eq. 11: s^ = (S / S_ref)^eta. As printed, B S delta_a is a volume times a length and G comes out in
/// J/m^4; with a weight it is J/m^2. S, S_ref in m^2 > 0. S_ref = s^2 of the hit body, s its mean particle spacing.
double contact_weight(double contact_area, double reference_area, double exponent);

/// r_outer = U / (G_c B s^), m: Eq. 11 read so that the radius is proportional to the energy at fixed G_c. U in J, the SUM over the group
/// (a mean of the particles' energies vanishes under refinement); G_c in J/m^2; B in m, the model's thickness. At most `cap` (m).
double proportional_radius(double energy, double toughness, double thickness, double weight, double cap);

/// Eq. 11 solved instead of scaled, G(a) = G_c, for a penny crack that a force F (N) pulls open at its centre, the far form of any local
/// tension: K = F / (pi a)^(3/2) (Tada, Paris, Irwin 2000), G = K^2 / E', so a = (F^2 / (pi^3 E' G_c))^(1/3), m. G falls with a, so the
/// crack rests there; the radius goes with the cube root of the energy, not with the energy. E' (Pa): E / (1 - nu^2), or
/// effective_modulus() of crack_tip.hpp. At most `cap`.
double wedged_radius(double force, double toughness, double modulus, double cap);

/// Radius inside which the energy density of the contact exceeds the limit, Sect. 4.2: energy U (J) spread by the poly6 kernel of support
/// radius h (m) has density 315 / (64 pi h^9) (h^2 - r^2)^3 U (the paper's formula lost the cube), so
///
///   r_inner = sqrt(h^2 - (64 pi h^9 U_limit / (315 U))^(1/3)),  0 where 315 U / (64 pi h^3) <= U_limit
///
/// h belongs to the contact's neighbourhood: with h = r_outer the inner radius would shrink as U grows. U_limit in J/m^3; 0 gives 0
/// (no inner radius). At most r_outer.
double inner_radius(double energy, double support_radius, double energy_limit, double outer_radius);

/// How a crack whose energy release rate is G(a) comes to rest.
enum class Rest { never_starts, stable, runs_through };

struct EquilibriumRadius {
    Rest rest = Rest::never_starts;
    double radius = 0;  ///< m: where it rests; `largest` where it runs through; `start` where it never starts
};

/// Griffith's balance G(a) = G_c of a crack that starts at radius `start` and may grow to `largest` (m): grows while G(a) >= G_c, rests at
/// the first a where G falls below. `release_rate` is evaluated at `samples` radii, geometrically spaced, then by bisection to 1e-6.
EquilibriumRadius equilibrium_radius(const std::function<double(double radius)>& release_rate, double toughness, double start,
                                     double largest, int samples = 32);

}  // namespace cleave::fracture
