#include "validation/analytic/uniform_stress.hpp"

#include <cmath>
#include <stdexcept>

namespace cleave::analytic {

namespace {

/// Rodrigues' formula: R = cos I + sin [n] + (1 - cos) n n^T.
Gradient rotation(const Point& axis, double angle) {
    const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    if (!(length > 0)) throw std::invalid_argument("an axis that is not zero");
    const double c = std::cos(angle), s = std::sin(angle), x = axis[0] / length, y = axis[1] / length, z = axis[2] / length;
    return {{{c + (1 - c) * x * x, (1 - c) * x * y - s * z, (1 - c) * x * z + s * y},
             {(1 - c) * x * y + s * z, c + (1 - c) * y * y, (1 - c) * y * z - s * x},
             {(1 - c) * x * z - s * y, (1 - c) * y * z + s * x, c + (1 - c) * z * z}}};
}

Voigt turned(const Voigt& v, const Gradient& r) {
    const Gradient stress{{{v[0], v[5], v[4]}, {v[5], v[1], v[3]}, {v[4], v[3], v[2]}}};
    Gradient result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t l = 0; l < 3; ++l) result[i][j] += r[i][k] * r[j][l] * stress[k][l];
    return {result[0][0], result[1][1], result[2][2], result[1][2], result[0][2], result[0][1]};
}

}  // namespace

Field uniform_stress(const Stiffness& stiffness, const Voigt& given, const Point& axis, double angle) {
    const Voigt stress = turned(given, rotation(axis, angle));
    const Stiffness compliance = invert(stiffness);
    Voigt strain{};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) strain[i] += compliance[i][j] * stress[j];
    const Gradient gradient{{{strain[0], strain[5] / 2, strain[4] / 2}, {strain[5] / 2, strain[1], strain[3] / 2}, {strain[4] / 2, strain[3] / 2, strain[2]}}};
    Field field;
    field.displacement = [gradient](const Point& x) {
        Point u{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) u[i] += gradient[i][j] * x[j];
        return u;
    };
    field.gradient = [gradient](const Point&) { return gradient; };
    field.stress = [stress](const Point&) { return stress; };
    field.source = "uniform stress: strain by the inverse of the stiffness";
    return field;
}

}  // namespace cleave::analytic
