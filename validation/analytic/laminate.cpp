#include "validation/analytic/laminate.hpp"

namespace cleave::analytic {

namespace {

/// Solves the 3x3 system by Cramer's rule.
Point solve(const Gradient& q, const Point& b) {
    const auto determinant = [](const Gradient& m) {
        return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    const double whole = determinant(q);
    Point x{};
    for (std::size_t column = 0; column < 3; ++column) {
        Gradient replaced = q;
        for (std::size_t row = 0; row < 3; ++row) replaced[row][column] = b[row];
        x[column] = determinant(replaced) / whole;
    }
    return x;
}

/// The gradient above the interface: the jump d (x) n keeps the displacement continuous, d balances the traction.
Gradient gradient_above(const Stiffness& lower, const Stiffness& upper, const Gradient& below) {
    const Voigt under = stress_of(lower, below), over = stress_of(upper, below);
    const Point jump{under[4] - over[4], under[3] - over[3], under[2] - over[2]};  // traction on n = z: xz, yz, zz
    Gradient acoustic{};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) acoustic[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = component(upper, i, 2, k, 2);
    const Point d = solve(acoustic, jump);
    Gradient above = below;
    for (std::size_t a = 0; a < 3; ++a) above[a][2] += d[a];
    return above;
}

}  // namespace

Field laminate(const Stiffness& lower, const Stiffness& upper, double height, const Gradient& below) {
    const Gradient above = gradient_above(lower, upper, below);
    const Voigt under = stress_of(lower, below), over = stress_of(upper, above);
    const auto is_upper = [height](const Point& x) { return x[2] > height; };
    Field field;
    field.displacement = [=](const Point& x) {
        const Gradient& g = is_upper(x) ? above : below;
        Point u{};
        for (std::size_t a = 0; a < 3; ++a) u[a] = g[a][0] * x[0] + g[a][1] * x[1] + below[a][2] * height + g[a][2] * (x[2] - height);
        return u;
    };
    field.gradient = [=](const Point& x) { return is_upper(x) ? above : below; };
    field.stress = [=](const Point& x) { return is_upper(x) ? over : under; };
    field.source = "piecewise linear laminate (Hadamard jump; Ting 1996)";
    return field;
}

}  // namespace cleave::analytic
