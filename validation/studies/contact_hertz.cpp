#include "validation/studies/contact_hertz.hpp"

#include "solver/contact/half_space.hpp"
#include "solver/contact/hertz.hpp"
#include "solver/contact/indentation.hpp"
#include "validation/analytic/elliptical_contact.hpp"
#include "validation/analytic/half_space_isotropic.hpp"
#include "validation/studies/contact_surfaces.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace cleave::validation {

namespace {

using std::numbers::pi;

void add(StudyOutcome& outcome, const std::string& quantity, const std::string& method, const std::string& place, double value) {
    outcome.values.push_back({quantity, method, place, value});
}

/// Rigid sphere R = 10 mm, P = 1 kN, E = 70 GPa, nu = 0.25.
void sphere(StudyOutcome& outcome) {
    const double young = 70e9, nu = 0.25;
    const double modulus = contact::contact_modulus(young / (1 - nu * nu), std::numeric_limits<double>::infinity());
    const contact::HertzContact hertz = contact::hertz_contact(1000, 10e-3, modulus);
    const std::string place = "sphere";
    add(outcome, "contact_radius", "solver", place, hertz.radius);
    add(outcome, "peak_pressure", "solver", place, hertz.peak_pressure);
    add(outcome, "approach", "solver", place, hertz.approach);
    add(outcome, "edge_tension", "solver", place, contact::hertz_edge_tension(hertz, nu));
    const contact::HalfSpaceField field = contact::half_space_field(material::isotropic(young, nu), {.force = {0, 0, 1000}, .radius = hertz.radius});
    add(outcome, "edge_tension", "field", place, field.stress({hertz.radius * (1 + 1e-8), 0, 0})[0]);
    add(outcome, "peak_pressure", "field", place, -field.stress({0, 0, 0})[2]);
    add(outcome, "approach", "field", place, field.displacement({0, 0, 0})[2]);
}

/// Largest shear on the axis (nu = 0.3) over p0, and its depth over a, by golden section.
void largest_shear(StudyOutcome& outcome) {
    const contact::HalfSpaceField field = contact::half_space_field(material::isotropic(1, 0.3), {.force = {0, 0, 2 * pi / 3}, .radius = 1});
    const auto shear = [&](double z) {
        const material::Voigt s = field.stress({0, 0, z});
        return (s[0] - s[2]) / 2;
    };
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double low = 0.2, high = 1;
    while (high - low > 1e-7) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        (shear(left) > shear(right) ? high : low) = shear(left) > shear(right) ? right : left;
    }
    add(outcome, "shear_over_pressure", "field", "axis", shear(low));
    add(outcome, "depth_over_radius", "field", "axis", low);
}

/// Johnson (1985), Eq. 3.41, with t = b tan(theta): deflection at the centre and curvatures as integrals over the confocal ellipsoids.
void ellipse_by_potential(const contact::EllipticalContact& c, double modulus, StudyOutcome& outcome) {
    const double a2 = c.major * c.major, b2 = c.minor * c.minor;
    double along = 0, across = 0, middle = 0;
    constexpr int steps = 2000;
    for (int i = 0; i < steps; ++i) {
        const double theta = pi / 2 * (i + 0.5) / steps, t = c.minor * std::tan(theta), w = t * t;
        const double share = c.minor / std::pow(std::cos(theta), 2) * pi / steps / std::sqrt((a2 + w) * (b2 + w));
        middle += share;
        along += share / (a2 + w);
        across += share / (b2 + w);
    }
    const double factor = c.peak_pressure * c.major * c.minor / (2 * modulus);
    add(outcome, "relative_radius", "solver", "along", 1 / (2 * factor * along));
    add(outcome, "relative_radius", "solver", "across", 1 / (2 * factor * across));
    add(outcome, "approach", "solver", "ellipse", c.approach);
    add(outcome, "approach", "integration", "ellipse", factor * middle);
}

/// How far the surface that a pressure makes is from touching bodies of the radii of curvature given, over the approach: Hertz's condition
/// u = delta - x^2/2R' - y^2/2R'' all over the ellipse.
double misfit(const analytic::EllipticalPressure& pressure, double approach, double modulus, double larger, double smaller) {
    double worst = 0;
    for (const double r : {0.0, 0.35, 0.7, 0.99})
        for (int k = 0; k < 12; ++k) {
            const double x = r * pressure.a * std::cos(pi * k / 6), y = r * pressure.b * std::sin(pi * k / 6);
            const double asked = approach - x * x / (2 * larger) - y * y / (2 * smaller);
            worst = std::max(worst, std::abs(analytic::surface_displacement(pressure, modulus, x, y) - asked) / approach);
        }
    return worst;
}

/// The solver's displacement below an elliptical patch under an oblique force against Boussinesq and Cerruti summed over the ellipse.
double elliptical_field_error(const contact::EllipticalContact& c, const Eigen::Vector3d& axis) {
    const double shear = 28e9, nu = 0.25, a = c.major, b = c.minor;
    const Eigen::Vector3d force(400, -300, 1000);
    const contact::HalfSpaceField field = contact::half_space_field(material::isotropic(2 * shear * (1 + nu), nu),
                                                                    {.force = force, .radius = a, .other_radius = b, .axis = axis});
    double worst = 0;
    for (const Eigen::Vector3d& x : {Eigen::Vector3d(0, 0, 0.8 * b), Eigen::Vector3d(0.7 * a, 0.3 * b, 0.6 * b), Eigen::Vector3d(-0.4 * a, 2 * b, b),
                                     Eigen::Vector3d(2 * a, -a, a)})
        worst = std::max(worst, relative(field.displacement(x), eigen(analytic::hertz_displacement_by_quadrature({shear, nu, plain(force), a, b}, plain(x)))));
    return worst;
}

/// 1 kN between bodies of relative radii 20 and 5 mm.
void ellipse(StudyOutcome& outcome) {
    const double modulus = 75e9, larger = 20e-3, smaller = 5e-3;
    const contact::EllipticalContact c = contact::elliptical_contact(1000, larger, smaller, modulus);
    ellipse_by_potential(c, modulus, outcome);
    const analytic::EllipticalPressure pressure{c.major, c.minor, c.peak_pressure};
    add(outcome, "misfit", "solver", "ellipse", misfit(pressure, c.approach, modulus, larger, smaller));
    add(outcome, "misfit", "turned", "ellipse", misfit(pressure, c.approach, modulus, smaller, larger));
    add(outcome, "resultant", "solver", "ellipse", analytic::resultant(pressure));
    // The circle of the same mean curvature under the same force, as contacts of scenes are.
    const contact::HertzContact circle = contact::hertz_contact(1000, std::sqrt(larger * smaller), modulus);
    add(outcome, "misfit", "circle", "ellipse", misfit({circle.radius, circle.radius, circle.peak_pressure}, circle.approach, modulus, larger, smaller));
    add(outcome, "displacement_error", "field", "ellipse", elliptical_field_error(c, Eigen::Vector3d::UnitX()));
    add(outcome, "displacement_error", "turned", "ellipse", elliptical_field_error(c, Eigen::Vector3d::UnitY()));
}

/// m x'' = -(4/3) E* sqrt(R) x^(3/2) by Runge and Kutta until the bodies part.
void impact(StudyOutcome& outcome) {
    const double mass = 0.01, radius = 8e-3, modulus = 60e9, speed = 3;
    const contact::Impact peak = contact::hertz_impact(mass, radius, modulus, speed);
    const double k = 4.0 / 3.0 * modulus * std::sqrt(radius) / mass;
    const auto pull = [k](double x) { return x > 0 ? -k * std::pow(x, 1.5) : 0; };
    const double dt = 1e-9;
    double x = 0, v = speed, deepest = 0, time = 0;
    for (; x > 0 || time == 0; time += dt) {
        const double v1 = v, a1 = pull(x), v2 = v + dt / 2 * a1, a2 = pull(x + dt / 2 * v1), v3 = v + dt / 2 * a2, a3 = pull(x + dt / 2 * v2);
        const double v4 = v + dt * a3, a4 = pull(x + dt * v3);
        const double before = x;
        x += dt / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
        v += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        deepest = std::max(deepest, x);
        if (x <= 0) {
            time += dt * before / (before - x);  // when it parted within the step
            break;
        }
    }
    add(outcome, "peak_force", "solver", "impact", peak.peak.force);
    add(outcome, "peak_force", "integration", "impact", k * mass * std::pow(deepest, 1.5));
    add(outcome, "contact_radius", "solver", "impact", peak.peak.radius);
    add(outcome, "contact_radius", "integration", "impact", std::sqrt(deepest * radius));
    add(outcome, "duration", "solver", "impact", peak.duration);
    add(outcome, "duration", "integration", "impact", time);
}

class ContactHertz final : public Study {
public:
    StudyOutcome run(const StudyContext&) const override {
        StudyOutcome outcome;
        sphere(outcome);
        largest_shear(outcome);
        ellipse(outcome);
        impact(outcome);
        return outcome;
    }
};

}  // namespace

StudyInfo contact_hertz_study() {
    return {"contact_hertz",
            "Hertz's contact: sphere on a plane, field at the rim and on the axis, elliptical contact, impact",
            {},
            {{"contact_radius", dimension::length}, {"peak_pressure", dimension::pressure}, {"approach", dimension::length},
             {"edge_tension", dimension::pressure}, {"shear_over_pressure", dimension::none}, {"depth_over_radius", dimension::none},
             {"relative_radius", dimension::length}, {"peak_force", dimension::force}, {"duration", dimension::time}, {"misfit", dimension::none},
             {"resultant", dimension::force}, {"displacement_error", dimension::none}},
            {"solver", "field", "integration", "turned", "circle"},
            [](TableReader&) -> std::shared_ptr<const Study> { return std::make_shared<ContactHertz>(); },
            {"integration"}};
}

}  // namespace cleave::validation
