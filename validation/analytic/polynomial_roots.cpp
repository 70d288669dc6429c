#include "validation/analytic/polynomial_roots.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::analytic {

std::vector<std::complex<double>> upper_roots(const std::vector<double>& coefficients) {
    using Complex = std::complex<double>;
    const std::size_t degree = coefficients.size() - 1;
    const double radius = std::pow(std::abs(coefficients.front() / coefficients.back()), 1.0 / static_cast<double>(degree));
    std::vector<Complex> roots(degree);
    for (std::size_t k = 0; k < degree; ++k) roots[k] = radius * std::pow(Complex(0.4, 0.9), static_cast<double>(k));
    for (int sweep = 0; sweep < 1000; ++sweep)
        for (std::size_t k = 0; k < degree; ++k) {
            Complex step = 1;
            for (std::size_t power = degree; power-- > 0;) step = step * roots[k] + coefficients[power] / coefficients.back();
            for (std::size_t other = 0; other < degree; ++other)
                if (other != k) step /= roots[k] - roots[other];
            roots[k] -= step;
        }
    std::vector<Complex> upper;
    for (const Complex& root : roots)
        if (root.imag() > 0) upper.push_back(root);
    std::sort(upper.begin(), upper.end(), [](const Complex& a, const Complex& b) { return std::abs(a) < std::abs(b); });
    return upper;
}

}  // namespace cleave::analytic
