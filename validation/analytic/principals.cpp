#include "validation/analytic/principals.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::analytic {

namespace {

/// (x_p, x_q) -> (c x_p - s x_q, s x_p + c x_q).
void turn(double& p, double& q, double c, double s) {
    const double old = p;
    p = c * old - s * q;
    q = s * old + c * q;
}

/// Turns the plane p, q so that the tensor's entry pq vanishes; the columns of `axes` turn along.
void annihilate(Gradient& tensor, Gradient& axes, int p, int q) {
    const double angle = 0.5 * std::atan2(2 * tensor[p][q], tensor[q][q] - tensor[p][p]), c = std::cos(angle), s = std::sin(angle);
    for (auto& row : tensor) turn(row[p], row[q], c, s);
    for (int k = 0; k < 3; ++k) turn(tensor[p][k], tensor[q][k], c, s);
    for (auto& row : axes) turn(row[p], row[q], c, s);
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Gradient symmetric(double xx, double yy, double zz, double yz, double xz, double xy) {
    return {{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
}

}  // namespace

double Principals::gap() const {
    const double norm = std::sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
    return norm > 0 ? (value[0] - value[1]) / norm : 0;
}

Principals principals(Gradient tensor) {
    constexpr int sweeps = 12;  // convergence is quadratic: four or five suffice
    Gradient axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) annihilate(tensor, axes, p, q);
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return tensor[a][a] > tensor[b][b]; });
    Principals result;
    for (int k = 0; k < 3; ++k) {
        result.value[k] = tensor[order[k]][order[k]];
        for (int i = 0; i < 3; ++i) result.direction[k][i] = axes[i][order[k]];
    }
    return result;
}

Gradient stress_tensor(const Voigt& s) { return symmetric(s[0], s[1], s[2], s[3], s[4], s[5]); }
Gradient strain_tensor(const Voigt& e) { return symmetric(e[0], e[1], e[2], e[3] / 2, e[4] / 2, e[5] / 2); }

Voigt strain_under(const Stiffness& stiffness, const Voigt& stress) {
    const Stiffness compliance = invert(stiffness);
    Voigt strain{};
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) strain[i] += compliance[i][j] * stress[j];
    return strain;
}

double angle_between(const Point& a, const Point& b) {
    const Point cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    return std::atan2(std::sqrt(dot(cross, cross)), std::abs(dot(a, b)));
}

}  // namespace cleave::analytic
