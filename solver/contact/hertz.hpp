#pragma once

namespace cleave::contact {

/// Contact of two spheres, or of a sphere and a plane (Hertz 1882; Johnson 1985, Sect. 4.2).
struct HertzContact {
    double force = 0;          ///< N
    double radius = 0;         ///< m, a
    double peak_pressure = 0;  ///< Pa, p0
    double approach = 0;       ///< m, delta, of the bodies' far points
};

/// a^3 = 3 P R / 4 E*, p0 = 3 P / 2 pi a^2, delta = a^2 / R. `radius` is the relative one, 1/R = 1/R1 + 1/R2 (m); `modulus` is E* (Pa):
/// contact_modulus() of E/(1 - nu^2) or of indentation moduli (exact for the mean compliance of a circular patch on any material, which
/// is the truth where the material's contact is nearly round). Throws std::invalid_argument where one is not positive.
HertzContact hertz_contact(double force, double radius, double modulus);

/// The same for a given approach (m).
HertzContact hertz_contact_of_approach(double approach, double radius, double modulus);

/// Largest tension in an isotropic body, at the edge of the contact: (1 - 2 nu) p0 / 3, Pa.
double hertz_edge_tension(const HertzContact& contact, double poisson_ratio);

/// Contact of curved bodies with principal relative radii of curvature R' >= R'' (Johnson 1985, Eqs. 4.23 to 4.32).
struct EllipticalContact {
    double major = 0, minor = 0;  ///< m, half axes: major along the direction of the larger radius
    double peak_pressure = 0;     ///< Pa, 3 P / (2 pi a b)
    double approach = 0;          ///< m
};

/// By complete elliptic integrals; no approximation. Throws std::invalid_argument where a value is not positive or the second radius
/// exceeds the first.
EllipticalContact elliptical_contact(double force, double larger_radius, double smaller_radius, double modulus);

/// What two bodies do between touching and parting (Hertz 1882; Johnson 1985, Sect. 11.4): quasi-static Hertz forces, no friction, no
/// loss. Right while the impact lasts longer than elastic waves need to cross the bodies.
struct Impact {
    HertzContact peak;    ///< at the deepest approach
    double duration = 0;  ///< s, 2.9432 delta / v
    double impulse = 0;   ///< N s, 2 m v
};

/// `mass` is the relative one, 1/m = 1/m1 + 1/m2 (kg); `speed` the approach velocity (m/s) > 0. The energy m v^2 / 2 becomes
/// (8/15) E* sqrt(R) delta^(5/2).
Impact hertz_impact(double mass, double radius, double modulus, double speed);

/// The impact that passes a given impulse J (N s), as a rigid-body step reports it: 2 m v = J.
Impact hertz_impact_of_impulse(double impulse, double mass, double radius, double modulus);

}  // namespace cleave::contact
