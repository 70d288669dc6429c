#include "solver/fracture/radii.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cleave::fracture {

using std::numbers::pi;

double contact_weight(double contact_area, double reference_area, double exponent) {
    return std::pow(contact_area / reference_area, exponent);
}

double proportional_radius(double energy, double toughness, double thickness, double weight, double cap) {
    return std::min(energy / (toughness * thickness * weight), cap);
}

double wedged_radius(double force, double toughness, double modulus, double cap) {
    return std::min(std::cbrt(force * force / (pi * pi * pi * modulus * toughness)), cap);
}

double inner_radius(double energy, double support_radius, double energy_limit, double outer_radius) {
    const double h2 = support_radius * support_radius, h3 = h2 * support_radius;
    if (energy_limit <= 0 || 315 * energy / (64 * pi * h3) <= energy_limit) return 0;
    const double cube = 64 * pi * h3 * h3 * h3 * energy_limit / (315 * energy);
    return std::min(std::sqrt(std::max(h2 - std::cbrt(cube), 0.0)), outer_radius);
}

EquilibriumRadius equilibrium_radius(const std::function<double(double radius)>& release_rate, double toughness, double start,
                                     double largest, int samples) {
    const auto grows = [&](double radius) { return release_rate(radius) >= toughness; };
    if (!grows(start)) return {Rest::never_starts, start};
    double inside = start;
    for (int k = 1; k <= samples; ++k) {
        double outside = start * std::pow(largest / start, static_cast<double>(k) / samples);
        if (grows(outside)) {
            inside = outside;
            continue;
        }
        while (outside - inside > 1e-6 * outside) {
            const double middle = 0.5 * (inside + outside);
            (grows(middle) ? inside : outside) = middle;
        }
        return {Rest::stable, 0.5 * (inside + outside)};
    }
    return {Rest::runs_through, largest};
}

}  // namespace cleave::fracture
