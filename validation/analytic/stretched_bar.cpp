#include "validation/analytic/stretched_bar.hpp"

#include "validation/analytic/barnett_lothe.hpp"

#include <stdexcept>

namespace cleave::analytic {

double bar_modulus(const Stiffness& stiffness, const Point& direction) {
    constexpr std::size_t along = 2;
    Stiffness c = in_axes(stiffness, axes_about(direction));
    for (std::size_t free = 0; free < 6; ++free) {
        if (free == along) continue;
        if (!(c[free][free] > 0)) throw std::invalid_argument("a stiffness that is positive definite");
        for (std::size_t i = 0; i < 6; ++i) {
            if (i == free) continue;
            const double factor = c[i][free] / c[free][free];
            for (std::size_t j = 0; j < 6; ++j) c[i][j] -= factor * c[free][j];
        }
    }
    if (!(c[along][along] > 0)) throw std::invalid_argument("a stiffness that is positive definite");
    return c[along][along];
}

}  // namespace cleave::analytic
