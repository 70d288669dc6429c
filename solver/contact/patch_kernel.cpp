#include "solver/contact/patch_kernel.hpp"

namespace cleave::contact {

namespace {

using Complex = std::complex<double>;

/// The real axis is taken from above; the rim itself just beside it.
Complex logarithm(const Complex& s) {
    const Complex above(s.real(), s.imag() > 1e-14 ? s.imag() : 1e-14);
    return std::log((above + 1.0) / (above - 1.0));
}

}  // namespace

Complex patch_kernel(const Complex& s) {
    if (std::norm(s) < patch_series_from) return 0.75 * ((1.0 - s * s) * logarithm(s) + 2.0 * s);
    const Complex inverse = 1.0 / s, square = inverse * inverse;
    Complex sum = 0;
    for (int k = patch_series_terms; k-- > 0;) sum = sum * square + patch_series_factor(k);
    return sum * inverse;
}

Complex patch_kernel_derivative(const Complex& s) {
    if (std::norm(s) < patch_series_from) return 3.0 - 1.5 * s * logarithm(s);
    const Complex inverse = 1.0 / s, square = inverse * inverse;
    Complex sum = 0;
    for (int k = patch_series_terms; k-- > 0;) sum = sum * square - (2 * k + 1) * patch_series_factor(k);
    return sum * square;
}

}  // namespace cleave::contact
