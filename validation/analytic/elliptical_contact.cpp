#include "validation/analytic/elliptical_contact.hpp"

#include "validation/analytic/gauss_rule.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::analytic {

using std::numbers::pi;

double surface_displacement(const EllipticalPressure& pressure, double modulus, double x, double y, int directions) {
    const double a2 = pressure.a * pressure.a, b2 = pressure.b * pressure.b, rest = 1 - x * x / a2 - y * y / b2;
    if (!(rest >= 0)) throw std::invalid_argument("a place inside the ellipse");
    double sum = 0;
    for (int k = 0; k < directions; ++k) {
        const double phi = pi * k / directions, c = std::cos(phi), s = std::sin(phi);
        // Along (x + rho c, y + rho s): (p/p0)^2 = rest - 2 B rho - C rho^2, a half ellipse over rho of half axes sqrt(B^2 + C rest)/C and
        // sqrt((B^2 + C rest)/C).
        const double B = x * c / a2 + y * s / b2, C = c * c / a2 + s * s / b2;
        sum += (B * B + C * rest) / std::pow(C, 1.5);
    }
    return pressure.peak / (pi * modulus) * pi / 2 * sum * pi / directions;
}

double resultant(const EllipticalPressure& pressure) {
    constexpr int directions = 128;
    double sum = 0;
    for (int k = 0; k < directions; ++k) {
        const double phi = 2 * pi * k / directions, rim = 1 / std::hypot(std::cos(phi) / pressure.a, std::sin(phi) / pressure.b);
        // rho = rim sqrt(1 - t^2): the pressure is p0 t, rho d rho = rim^2 t dt.
        for (const auto& [node, weight] : gauss_rule(8)) {
            const double t = (1 + node) / 2;
            sum += weight / 2 * pressure.peak * t * rim * rim * t * 2 * pi / directions;
        }
    }
    return sum;
}

}  // namespace cleave::analytic
