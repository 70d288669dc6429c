#include "reference_fem/recovery.hpp"
#include "reference_fem/solution_data.hpp"

#include <cmath>

namespace cleave::fem {

std::vector<double> Solution::cell_errors() const {
    PatchRecovery recovery(*data_);
    // The recovered strain is of one degree more than the solution's, so its square needs the next rule.
    const ShapeTable table(data_->space, data_->options.degree + 1);
    std::vector<double> errors(data_->mesh.cells.size(), 0.0);
    for (int cell = 0; cell < static_cast<int>(errors.size()); ++cell) {
        for (std::size_t q = 0; q < table.rule.points.size(); ++q) {
            const auto local = data_->evaluate(cell, table.values[q], table.gradients[q], table.rule.points[q]);
            Voigt difference = recovery.sample({cell, table.rule.points[q]}).strain;
            const Voigt strain = engineering_strain(local.gradient);
            for (int i = 0; i < 6; ++i) difference[i] -= strain[i];
            const Voigt stress = data_->materials[cell]->stress(difference);
            for (int i = 0; i < 6; ++i) errors[cell] += local.volume_factor * table.rule.weights[q] * stress[i] * difference[i];
        }
        errors[cell] = std::sqrt(errors[cell]);
    }
    return errors;
}

double Solution::estimated_error() const {
    double sum = 0;
    for (const double error : cell_errors()) sum += error * error;
    return std::sqrt(sum / (2 * energy()));
}

}  // namespace cleave::fem
