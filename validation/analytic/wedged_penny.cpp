#include "validation/analytic/wedged_penny.hpp"

#include <cmath>
#include <numbers>

namespace cleave::analytic {

double wedged_penny_release(double young, double poisson, double force, double load_radius, double crack_radius) {
    const double pi = std::numbers::pi, a = crack_radius, c = load_radius, pressure = force / (pi * c * c);
    // a - sqrt(a^2 - c^2) without its cancellation
    const double intensity = 2 * pressure / std::sqrt(pi * a) * c * c / (a + std::sqrt(a * a - c * c));
    return intensity * intensity * (1 - poisson * poisson) / young;
}

}  // namespace cleave::analytic
