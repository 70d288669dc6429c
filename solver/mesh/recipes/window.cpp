#include "solver/mesh/recipes/window.hpp"

#include <fmt/format.h>
#include <gmsh.h>

namespace cleave::mesh {

OccBody window_body(const WindowShape& s) {
    const auto build = [s] {
        const int slab = gmsh::model::occ::addBox(-s.width / 2, -s.height / 2, 0, s.width, s.height, s.thickness);
        return std::vector<Region>{{"window", {slab}}};
    };
    return {"window", fmt::format("1 width {:.17g} height {:.17g} thickness {:.17g}", s.width, s.height, s.thickness), build, s.thickness,
            s.thickness};
}

}  // namespace cleave::mesh
