#include "validation/geometry/box_sides.hpp"

#include <gmsh.h>

#include <cmath>

namespace cleave::geometry {

const std::vector<std::string>& box_side_names() {
    static const std::vector<std::string> names{"left", "right", "front", "back", "bottom", "top"};
    return names;
}

double tets_of_box(const std::array<double, 3>& extent, double size) {
    return 6 * std::sqrt(2.0) * (extent[0] / size) * (extent[1] / size) * (extent[2] / size);
}

int box_side_of(int face, const std::array<double, 3>& low, const std::array<double, 3>& high) {
    std::array<double, 3> centre{};
    gmsh::model::occ::getCenterOfMass(2, face, centre[0], centre[1], centre[2]);
    for (std::size_t k = 0; k < 3; ++k) {
        const double near = 1e-6 * (high[k] - low[k]);
        if (std::abs(centre[k] - low[k]) < near) return static_cast<int>(2 * k) + 1;
        if (std::abs(centre[k] - high[k]) < near) return static_cast<int>(2 * k) + 2;
    }
    return 0;
}

}  // namespace cleave::geometry
