#include "validation/analytic/sneddon_penny.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::analytic {

namespace {

/// E / (1 - nu^2) of an isotropic stiffness.
double plane_strain_modulus(const Stiffness& c) {
    const double lambda = c[0][1], shear = c[3][3], scale = 1e-6 * c[0][0];
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) {
            const double isotropic = i < 3 && j < 3 ? lambda + (i == j ? 2 * shear : 0) : (i == j ? shear : 0);
            if (std::abs(c[i][j] - isotropic) > scale) throw std::invalid_argument("an isotropic material");
        }
    const double poisson = lambda / (2 * (lambda + shear)), young = 2 * shear * (1 + poisson);
    return young / (1 - poisson * poisson);
}

}  // namespace

Field sneddon_penny(const Stiffness& stiffness, double radius, double pressure, double box_factor) {
    const double modulus = plane_strain_modulus(stiffness), pi = std::numbers::pi;
    Field field;
    field.scalars["energy_release_rate"] = box_factor * 4 * pressure * pressure * radius / (pi * modulus);
    field.scalars["energy_release_rate_domain"] = field.scalars["energy_release_rate"];
    field.scalars["crack_opening"] = box_factor * 8 * pressure * radius / (pi * modulus);
    field.scalars["energy"] = box_factor * 8 * pressure * pressure * radius * radius * radius / (3 * modulus);
    field.source = "Sneddon 1946";
    return field;
}

}  // namespace cleave::analytic
