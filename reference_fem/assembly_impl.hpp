#pragma once

#include "reference_fem/discretization_impl.hpp"

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace cleave::fem {

/// Local number of each (node, component) in the vector-valued element.
class LocalNumbers {
public:
    explicit LocalNumbers(const dealii::FESystem<3>& element) : nodes(element.n_dofs_per_cell() / 3), numbers_(element.n_dofs_per_cell()) {
        for (unsigned int i = 0; i < numbers_.size(); ++i) {
            const auto [component, node] = element.system_to_component_index(i);
            numbers_[3 * node + component] = i;
        }
    }
    unsigned int operator()(unsigned int node, int component) const { return numbers_[3 * node + component]; }
    const unsigned int nodes;

private:
    std::vector<unsigned int> numbers_;
};

/// Element stiffness: int phi_a,k C_ikjl phi_b,l dV for the component i of node a and j of node b.
dealii::FullMatrix<double> cell_stiffness(const dealii::FEValues<3>& values, const LocalNumbers& local, const Elasticity& material);

}  // namespace cleave::fem
