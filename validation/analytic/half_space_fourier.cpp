#include "validation/analytic/half_space_fourier.hpp"

#include "validation/analytic/gauss_rule.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::analytic {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;
constexpr Complex I{0, 1};

ComplexMatrix operator*(const ComplexMatrix& a, const ComplexMatrix& b) {
    ComplexMatrix c{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
    return c;
}

/// a + factor b.
ComplexMatrix plus(const ComplexMatrix& a, const Complex& factor, const ComplexMatrix& b) {
    ComplexMatrix c = a;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) c[i][j] += factor * b[i][j];
    return c;
}

ComplexMatrix transpose(const ComplexMatrix& a) {
    ComplexMatrix c;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) c[i][j] = a[j][i];
    return c;
}

constexpr ComplexMatrix one{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// By cofactors.
ComplexMatrix inverse(const ComplexMatrix& a) {
    ComplexMatrix c;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t r = (j + 1) % 3, s = (j + 2) % 3, p = (i + 1) % 3, q = (i + 2) % 3;
            c[i][j] = a[r][p] * a[s][q] - a[r][q] * a[s][p];
        }
    const Complex determinant = a[0][0] * c[0][0] + a[0][1] * c[1][0] + a[0][2] * c[2][0];
    for (auto& row : c)
        for (Complex& value : row) value /= determinant;
    return c;
}

/// (uv)_ik = C_ijks u_j v_s.
ComplexMatrix bracket(const Stiffness& stiffness, const Point& u, const Point& v) {
    ComplexMatrix c{};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j)
                for (int s = 0; s < 3; ++s)
                    c[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] +=
                        component(stiffness, i, j, k, s) * u[static_cast<std::size_t>(j)] * v[static_cast<std::size_t>(s)];
    return c;
}

/// The integrals of Barnett and Lothe over half a turn of the axes (m, n) about m x n.
struct BarnettLothe {
    ComplexMatrix S{}, H{}, L{};
};

BarnettLothe integrate(const Stiffness& stiffness, const Point& m, const Point& n, int steps) {
    BarnettLothe sum;
    for (int k = 0; k < steps; ++k) {
        const double omega = pi * k / steps, c = std::cos(omega), s = std::sin(omega);
        Point mm, nn;
        for (std::size_t i = 0; i < 3; ++i) mm[i] = c * m[i] + s * n[i], nn[i] = c * n[i] - s * m[i];
        const ComplexMatrix inverted = inverse(bracket(stiffness, nn, nn)), coupling = bracket(stiffness, mm, nn);
        const ComplexMatrix mixed = inverted * transpose(coupling);
        sum.S = plus(sum.S, -1.0 / steps, mixed);
        sum.H = plus(sum.H, 1.0 / steps, inverted);
        sum.L = plus(sum.L, 1.0 / steps, plus(bracket(stiffness, mm, mm), -1, coupling * mixed));
    }
    return sum;
}

double difference(const ComplexMatrix& a, const ComplexMatrix& b) {
    double most = 0, scale = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            most = std::max(most, std::abs(a[i][j] - b[i][j]));
            scale = std::max(scale, std::abs(b[i][j]));
        }
    return most / scale;
}

/// Doubled until H no longer changes: the rule converges geometrically.
BarnettLothe barnett_lothe(const Stiffness& stiffness, const Point& m, const Point& n) {
    BarnettLothe last = integrate(stiffness, m, n, 32);
    for (int steps = 64; steps <= 2048; steps *= 2) {
        const BarnettLothe next = integrate(stiffness, m, n, steps);
        if (difference(last.H, next.H) < 1e-13) return next;
        last = next;
    }
    throw std::runtime_error("integrals of Barnett and Lothe that converge");
}

Point times(const ComplexMatrix& a, const std::array<Complex, 3>& v, std::array<Complex, 3>& result) {
    Point real;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = a[i][0] * v[0] + a[i][1] * v[1] + a[i][2] * v[2];
        real[i] = result[i].real();
    }
    return real;
}

/// The pressure as line loads: offsets over the radius, and shares (3/4)(1 - s^2) ds; one at the centre for a point force.
std::vector<std::pair<double, double>> line_loads(double radius, int count) {
    if (radius <= 0) return {{0, 1}};
    std::vector<std::pair<double, double>> lines = gauss_rule(count);
    for (auto& [s, weight] : lines) weight *= 0.75 * (1 - s * s);
    return lines;
}

double size(const FourierHalfSpace::Response& response) {
    double sum = 0;
    for (const auto& row : response.gradient)
        for (const double value : row) sum += value * value;
    return std::sqrt(sum);
}

FourierHalfSpace::Response minus(FourierHalfSpace::Response a, const FourierHalfSpace::Response& b) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) a.gradient[i][j] -= b.gradient[i][j];
    return a;
}

}  // namespace

FourierHalfSpace::FourierHalfSpace(const Stiffness& stiffness) : stiffness_(stiffness) {}

FourierHalfSpace::Direction FourierHalfSpace::direction(double phi) const {
    const Point m{std::cos(phi), std::sin(phi), 0}, n{0, 0, 1};
    const BarnettLothe integrals = barnett_lothe(stiffness_, m, n);
    const ComplexMatrix impedance = inverse(integrals.H) * plus(one, I, integrals.S);
    const ComplexMatrix T = bracket(stiffness_, n, n), R = bracket(stiffness_, m, n);
    Direction result{m[0], m[1], inverse(T) * plus(impedance, I, transpose(R)), inverse(impedance)};
    for (auto& row : result.decay)
        for (Complex& value : row) value = -value;
    return result;
}

const std::vector<FourierHalfSpace::Direction>& FourierHalfSpace::directions(int count) const {
    std::vector<Direction>& known = cache_[count];
    // Half a turn: the other half gives the complex conjugate.
    for (int k = static_cast<int>(known.size()); k < count / 2; ++k) known.push_back(direction(2 * pi * k / count));
    return known;
}

double FourierHalfSpace::surface_compliance(double phi) const {
    const BarnettLothe integrals = barnett_lothe(stiffness_, {std::cos(phi), std::sin(phi), 0}, {0, 0, 1});
    return inverse(integrals.L)[2][2].real();
}

double FourierHalfSpace::indentation_modulus(int count) const {
    double mean = 0;
    for (int k = 0; k < count; ++k) mean += surface_compliance(2 * pi * k / count) / count;
    return 2 / mean;
}

std::array<std::array<double, 2>, 2> FourierHalfSpace::curvature_integral(int count) const {
    std::array<std::array<double, 2>, 2> sum{};
    for (int k = 0; k < count; ++k) {
        const double phi = 2 * pi * k / count, h = surface_compliance(phi);
        const std::array<double, 2> m{std::cos(phi), std::sin(phi)};
        for (std::size_t a = 0; a < 2; ++a)
            for (std::size_t b = 0; b < 2; ++b) sum[a][b] += 2 * pi / count * h * m[a] * m[b];
    }
    return sum;
}

FourierHalfSpace::Response FourierHalfSpace::sum(const Point& force, double radius, const Point& at, int count) const {
    Response response{};
    const auto lines = line_loads(radius, std::max(12, count / 8));
    for (const Direction& one_of : directions(count)) {
        std::array<Complex, 3> source, u, slope;
        times(one_of.compliance, {force[0], force[1], force[2]}, source);
        for (const auto& [offset, share] : lines) {
            // Integral of exp(k B) over k: -B^-1, with B = i (m.x + a s) + z M. Twice the real part for the other half of the turn.
            const double along = one_of.cosine * at[0] + one_of.sine * at[1] + radius * offset;
            ComplexMatrix B = one_of.decay;
            for (auto& row : B)
                for (Complex& value : row) value *= at[2];
            const ComplexMatrix resolvent = inverse(plus(B, I * along, one));
            const double factor = -2 * share * (2 * pi / count) / (4 * pi * pi);
            const Point real = times(resolvent, source, u);
            for (std::size_t i = 0; i < 3; ++i) response.displacement[i] += factor * real[i];
            // dB/dx_b = i m_b or M: d(B^-1) = -B^-1 dB B^-1, and M commutes with B.
            times(resolvent, u, slope);
            for (std::size_t i = 0; i < 3; ++i) {
                response.gradient[i][0] -= factor * (I * one_of.cosine * slope[i]).real();
                response.gradient[i][1] -= factor * (I * one_of.sine * slope[i]).real();
            }
            std::array<Complex, 3> deeper;
            const Point normal = times(one_of.decay, slope, deeper);
            for (std::size_t i = 0; i < 3; ++i) response.gradient[i][2] -= factor * normal[i];
        }
    }
    return response;
}

FourierHalfSpace::Response FourierHalfSpace::response(const Point& force, double radius, const Point& at, double tolerance) const {
    if (!(at[2] > 0)) throw std::invalid_argument("a point inside the half-space");
    Response last = sum(force, radius, at, 64);
    for (int count = 128; count <= 8192; count *= 2) {
        const Response next = sum(force, radius, at, count);
        if (size(minus(last, next)) < tolerance * size(next)) return next;
        last = next;
    }
    throw std::runtime_error("a sum over directions that converges (the point is too shallow)");
}

}  // namespace cleave::analytic
