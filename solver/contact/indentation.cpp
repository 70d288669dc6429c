#include "solver/contact/indentation.hpp"

#include "solver/contact/stroh_table.hpp"

#include <cmath>

namespace cleave::contact {

double surface_compliance(const HalfSpace& half_space, double phi) {
    const StrohDirection direction = stroh_direction(half_space.stroh_table()->stiffness(), phi);
    const Eigen::Matrix3cd sum = direction.matrix[0] + direction.matrix[1] + direction.matrix[2];  // A B^-1
    return -sum(2, 2).imag();
}

double indentation_modulus(const HalfSpace& half_space, int directions) {
    // h(phi + pi) = h(phi): half a turn does.
    double sum = 0;
    for (int k = 0; k < directions / 2; ++k) sum += surface_compliance(half_space, 2 * M_PI * (k + 0.5) / directions);
    return directions / sum;  // 4 pi / (2 pi mean h) = 2 / mean h
}

double indentation_modulus(const material::Stiffness& stiffness, const Eigen::Vector3d& inward, int directions) {
    return indentation_modulus(HalfSpace(stiffness, inward), directions);
}

double contact_modulus(double first, double second) { return 1 / (1 / first + 1 / second); }

}  // namespace cleave::contact
