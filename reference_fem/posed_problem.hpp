#pragma once

#include "reference_fem/inertia_relief.hpp"
#include "reference_fem/solution_data.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace cleave::fem {

/// A problem up to its linear system: mesh, unknowns, nodal loads, prescribed values.
class PosedProblem {
public:
    /// Throws Error, see solve().
    PosedProblem(const Problem& problem, const Options& options);

    const Solution::Data& data() const { return *data_; }
    const std::vector<double>& load() const { return load_; }  ///< N, by dof
    const PrescribedValues& prescribed() const { return prescribed_; }

    /// The solution from its displacement, m, by dof, and a record with solver, iterations, residual and bytes filled in; the rest is added
    /// here. To be called once.
    Solution conclude(std::vector<double> displacement, SolveRecord record, double seconds);

private:
    std::shared_ptr<Solution::Data> data_;
    std::vector<double> load_;
    std::optional<InertiaRelief> relief_;
    PrescribedValues prescribed_;
};

}  // namespace cleave::fem
