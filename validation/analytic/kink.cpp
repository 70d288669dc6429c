#include "validation/analytic/kink.hpp"

#include <cmath>
#include <numbers>

namespace cleave::analytic {

namespace {

constexpr double pi = std::numbers::pi;

/// Largest of f over [-limit, limit], by golden section around the best of a grid of 1 deg.
template <class Function>
double argmax(const Function& f, double limit) {
    const double step = pi / 180;
    const int steps = static_cast<int>(2 * limit / step);
    double best = 0;
    for (int k = 0; k <= steps; ++k)
        if (const double x = -limit + k * step; f(x) > f(best)) best = x;
    double low = best - step, high = best + step;
    constexpr double golden = 0.6180339887498949;
    while (high - low > 1e-10) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        (f(left) > f(right) ? high : low) = f(left) > f(right) ? right : left;
    }
    return (low + high) / 2;
}

}  // namespace

double hoop_kink_angle(double K_I, double K_II) {
    if (K_II == 0) return 0;
    // tan(theta/2) = (K_I - sqrt(K_I^2 + 8 K_II^2)) / (4 K_II)
    return 2 * std::atan((K_I - std::sqrt(K_I * K_I + 8 * K_II * K_II)) / (4 * K_II));
}

std::array<double, 4> kink_factors(double angle) {
    const double m = angle / pi, q = m * m;
    const double p2 = pi * pi, p3 = p2 * pi, p4 = p2 * p2, p5 = p4 * pi, p6 = p4 * p2;
    const double F11 = 1 + q * (-3 * p2 / 8 + q * (p2 - 5 * p4 / 128 + q * (p2 / 9 - 11 * p4 / 72 + 119 * p6 / 15360 +
                       q * (5.07790 + q * (-2.88312 + q * (-0.0925 + q * (2.996 + q * (-4.059 + q * (1.63 + q * 4.1)))))))));
    const double F12 = m * (-3 * pi / 2 + q * (10 * pi / 3 + p3 / 16 + q * (-2 * pi - 133 * p3 / 180 + 59 * p5 / 1280 +
                       q * (12.313906 + q * (-7.32433 + q * (1.5793 + q * (4.0216 + q * (-6.915 + q * (4.21 + q * 4.56)))))))));
    const double F21 = m * (pi / 2 + q * (-4 * pi / 3 - p3 / 48 + q * (-2 * pi / 3 + 13 * p3 / 30 - 59 * p5 / 3840 +
                       q * (-6.176023 + q * (4.44112 + q * (-1.5340 + q * (-2.0700 + q * (4.684 + q * (-3.95 - q * 1.32)))))))));
    const double F22 = 1 + q * (-4 - 3 * p2 / 8 + q * (8.0 / 3 + 29 * p2 / 18 - 5 * p4 / 128 +
                       q * (-32.0 / 15 - 4 * p2 / 9 - 1159 * p4 / 7200 + 119 * p6 / 15360 +
                       q * (10.58254 + q * (-4.78511 + q * (-1.8804 + q * (7.280 + q * (-7.591 + q * (0.25 + q * 12.5)))))))));
    return {F11, F12, F21, F22};
}

double energy_kink_angle(double K_I, double K_II) {
    return argmax(
        [&](double angle) {
            const auto [F11, F12, F21, F22] = kink_factors(angle);
            const double opening = F11 * K_I + F12 * K_II, sliding = F21 * K_I + F22 * K_II;
            return opening > 0 ? opening * opening + sliding * sliding : 0;
        },
        85 * pi / 180);
}

double symmetry_kink_angle(double K_I, double K_II) {
    return argmax(
        [&](double angle) {
            const auto [F11, F12, F21, F22] = kink_factors(angle);
            return F11 * K_I + F12 * K_II > 0 ? -std::abs(F21 * K_I + F22 * K_II) : -INFINITY;
        },
        85 * pi / 180);
}

double anisotropic_kink_angle(const AnisotropicHoop& hoop, double K_I, double K_II, const WeakPlane& toughness) {
    return argmax(
        [&](double angle) {
            const double along = std::cos(angle - toughness.weak_plane), across = std::sin(angle - toughness.weak_plane);
            return hoop(angle, K_I, K_II) / (along * along + toughness.ratio * across * across);
        },
        179 * pi / 180);
}

}  // namespace cleave::analytic
