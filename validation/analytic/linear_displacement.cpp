#include "validation/analytic/linear_displacement.hpp"

namespace cleave::analytic {

Gradient generic_gradient() { return {{{1.1e-3, -0.4e-3, 0.7e-3}, {0.9e-3, -0.8e-3, 0.3e-3}, {-0.2e-3, 0.6e-3, 0.5e-3}}}; }

Field linear_displacement(const Stiffness& stiffness, const Gradient& gradient) {
    const Voigt stress = stress_of(stiffness, gradient);
    Field field;
    field.displacement = [gradient](const Point& x) {
        Point u{};
        for (std::size_t a = 0; a < 3; ++a) u[a] = gradient[a][0] * x[0] + gradient[a][1] * x[1] + gradient[a][2] * x[2];
        return u;
    };
    field.gradient = [gradient](const Point&) { return gradient; };
    field.stress = [stress](const Point&) { return stress; };
    field.source = "linear displacement, patch test (Irons and Razzaque 1972)";
    return field;
}

}  // namespace cleave::analytic
