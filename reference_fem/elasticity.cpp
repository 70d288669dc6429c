#include "reference_fem/elasticity.hpp"

#include "reference_fem/posed_problem.hpp"

#include <fmt/format.h>

#include <chrono>

namespace cleave::fem {
namespace {

using Clock = std::chrono::steady_clock;

SparseSolution solve_system(const SparseSystem& system, const Options& options) {
    const bool direct = options.solver == Solver::direct || (options.solver == Solver::automatic && system.size() <= options.direct_limit);
    SparseSolution solution = direct ? solve_direct(system) : solve_iterative(system, options.tolerance, options.iteration_limit);
    // 1e-6 would already spoil the reference; a sound system stays below 1e-10.
    if (!(solution.relative_residual < 1e-6))
        throw Error(fmt::format("the linear solver left a residual of {:.1e}", solution.relative_residual));
    return solution;
}

std::vector<double> gather(const Assembly& assembly, const PrescribedValues& prescribed, const std::vector<double>& values, int dofs) {
    std::vector<double> displacement(dofs, 0.0);
    for (const auto& [dof, value] : prescribed) displacement[dof] = value;
    for (std::size_t row = 0; row < values.size(); ++row) displacement[assembly.free_dofs[row]] = values[row];
    return displacement;
}

}  // namespace

Solution solve(const Problem& problem, const Options& options) {
    const Clock::time_point start = Clock::now();
    PosedProblem posed(problem, options);
    const Assembly assembly = assemble(posed.data().space, posed.data().materials, posed.load(), posed.prescribed());
    const SparseSolution solution = solve_system(assembly.system, options);
    return posed.conclude(gather(assembly, posed.prescribed(), solution.values, posed.data().space.dofs()),
                          {.solver = solution.solver,
                           .iterations = solution.iterations,
                           .relative_residual = solution.relative_residual,
                           .matrix_bytes = solution.bytes},
                          std::chrono::duration<double>(Clock::now() - start).count());
}

}  // namespace cleave::fem
