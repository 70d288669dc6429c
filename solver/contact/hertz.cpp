#include "solver/contact/hertz.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <cmath>
#include <stdexcept>

namespace cleave::contact {

namespace {

void check_positive(double value, const char* what) {
    if (!(value > 0) || !std::isfinite(value)) throw std::invalid_argument(what);
}

void check(double first, const char* what, double radius, double modulus) {
    check_positive(first, what);
    check_positive(radius, "a relative radius above zero");
    check_positive(modulus, "a contact modulus above zero");
}

/// Time from touching to parting over delta/v: 2 integral of dx / sqrt(1 - x^(5/2)) from 0 to 1 = (4/5) B(2/5, 1/2).
const double duration_factor = 0.8 * std::exp(std::lgamma(0.4) + std::lgamma(0.5) - std::lgamma(0.9));

/// Complete elliptic integrals of modulus e, and Johnson's ratio of the radii of curvature they belong to (Eq. 4.28):
/// R'/R'' = [(a/b)^2 E - K] / [K - E].
struct Ellipse {
    double K, E, axis_ratio;  // a/b >= 1
    explicit Ellipse(double e)
        : K(gsl_sf_ellint_Kcomp(e, GSL_PREC_DOUBLE)), E(gsl_sf_ellint_Ecomp(e, GSL_PREC_DOUBLE)), axis_ratio(1 / std::sqrt((1 - e) * (1 + e))) {}
    double radius_ratio() const { return (axis_ratio * axis_ratio * E - K) / (K - E); }
};

/// The eccentricity with the given ratio of radii > 1, by bisection of t in e = 1 - exp(-t): monotone.
double eccentricity(double ratio) {
    double low = 1e-4, high = 36;
    for (int step = 0; step < 200 && high - low > 1e-15 * high; ++step) {
        const double middle = 0.5 * (low + high);
        (Ellipse(1 - std::exp(-middle)).radius_ratio() < ratio ? low : high) = middle;
    }
    return 1 - std::exp(-0.5 * (low + high));
}

}  // namespace

HertzContact hertz_contact(double force, double radius, double modulus) {
    check(force, "a force above zero", radius, modulus);
    const double a = std::cbrt(0.75 * force * radius / modulus);
    return {force, a, 1.5 * force / (M_PI * a * a), a * a / radius};
}

HertzContact hertz_contact_of_approach(double approach, double radius, double modulus) {
    check(approach, "an approach above zero", radius, modulus);
    return hertz_contact(4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(approach, 1.5), radius, modulus);
}

double hertz_edge_tension(const HertzContact& contact, double poisson_ratio) { return (1 - 2 * poisson_ratio) * contact.peak_pressure / 3; }

EllipticalContact elliptical_contact(double force, double larger_radius, double smaller_radius, double modulus) {
    check(force, "a force above zero", larger_radius, modulus);
    check_positive(smaller_radius, "a relative radius above zero");
    if (smaller_radius > larger_radius) throw std::invalid_argument("the larger relative radius first");
    if (larger_radius <= smaller_radius * (1 + 1e-7)) {  // K - E and the rest vanish with e^2
        const HertzContact circle = hertz_contact(force, std::sqrt(larger_radius * smaller_radius), modulus);
        return {circle.radius, circle.radius, circle.peak_pressure, circle.approach};
    }
    const double e = eccentricity(larger_radius / smaller_radius);
    const Ellipse ellipse(e);
    // Johnson (1985), Eqs. 4.26: A = 1/2R' = (p0/E*) (b/e^2 a^2)(K - E), delta = (p0/E*) b K, P = (2/3) p0 pi a b.
    const double k = ellipse.axis_ratio;
    const double minor = std::cbrt(3 * force * larger_radius * (ellipse.K - ellipse.E) / (M_PI * modulus * e * e * k * k * k));
    const double major = k * minor, pressure = 1.5 * force / (M_PI * major * minor);
    return {major, minor, pressure, pressure / modulus * minor * ellipse.K};
}

Impact hertz_impact(double mass, double radius, double modulus, double speed) {
    check(speed, "an approach speed above zero", radius, modulus);
    check_positive(mass, "a relative mass above zero");
    const double approach = std::pow(15 * mass * speed * speed / (16 * modulus * std::sqrt(radius)), 0.4);
    return {hertz_contact_of_approach(approach, radius, modulus), duration_factor * approach / speed, 2 * mass * speed};
}

Impact hertz_impact_of_impulse(double impulse, double mass, double radius, double modulus) {
    check_positive(mass, "a relative mass above zero");
    return hertz_impact(mass, radius, modulus, impulse / (2 * mass));
}

}  // namespace cleave::contact
