#include "reference_fem/nodal_forces.hpp"

#include <numeric>

namespace cleave::fem {

std::vector<double> internal_forces(const Solution::Data& data, std::span<const int> cells) {
    const ShapeTable table(data.space, data.options.degree);
    std::vector<double> internal(data.displacement.size(), 0.0);
    for (const int cell : cells)
        for (std::size_t q = 0; q < table.rule.points.size(); ++q) {
            const auto local = data.evaluate(cell, table.values[q], table.gradients[q], table.rule.points[q]);
            const Voigt stress = data.materials[cell]->stress(local.gradient);
            const double weight = local.volume_factor * table.rule.weights[q];
            for (int node = 0; node < data.space.nodes_per_cell(); ++node)
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j)
                        internal[data.space.dof(cell, node, i)] += weight * stress[voigt_index(i, j)] * local.shape_gradients[node][j];
        }
    return internal;
}

std::vector<double> add_energies(Solution::Data& data, const std::vector<double>& load, const PrescribedValues& prescribed) {
    std::vector<int> cells(data.mesh.cells.size());
    std::iota(cells.begin(), cells.end(), 0);
    const std::vector<double> internal = internal_forces(data, cells);
    for (std::size_t dof = 0; dof < internal.size(); ++dof) {
        data.energy += 0.5 * internal[dof] * data.displacement[dof];
        data.external_work += (prescribed.contains(static_cast<int>(dof)) ? internal[dof] : load[dof]) * data.displacement[dof];
    }
    return internal;
}

}  // namespace cleave::fem
