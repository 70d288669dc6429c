#include "validation/analytic/finite_width.hpp"

#include <cmath>
#include <numbers>

namespace cleave::analytic {

double centre_crack_factor(double ratio) {
    const double square = ratio * ratio;
    return (1 - 0.025 * square + 0.06 * square * square) / std::sqrt(std::cos(std::numbers::pi * ratio / 2));
}

double edge_crack_factor(double ratio) { return 1.12 + ratio * (-0.231 + ratio * (10.55 + ratio * (-21.72 + ratio * 30.39))); }

double elliptical_crack_factor(double a, double b, double phi) {
    const double s = std::sin(phi), c = b / a * std::cos(phi);
    return std::pow(s * s + c * c, 0.25) / std::comp_ellint_2(std::sqrt(1 - b * b / (a * a)));
}

}  // namespace cleave::analytic
