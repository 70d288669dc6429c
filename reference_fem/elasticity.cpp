#include "reference_fem/elasticity.hpp"

#include "reference_fem/posed_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace cleave::fem {
namespace {

using Clock = std::chrono::steady_clock;

/// The iteration takes 25 steps on compact tets, and hundreds on the flat ones of a laminate (524 at 160,000 unknowns): a factorisation then.
/// Trilinos' ML beside it in one run (cleave-fem penny_particles --size 0.13 --check): 156,000 unknowns, 37 steps against 24, 38 s against 25 s; on
/// the laminate's flat tets ML took longer still. Hence ML only where ranks share the work (distributed.hpp).
constexpr int patience = 150;

SparseSolution solve_automatically(const SparseSystem& system, const Options& options) {
    if (system.size() <= options.direct_limit) return solve_direct(system);
    try {
        return solve_iterative(system, options.tolerance, std::min(patience, options.iteration_limit));
    } catch (const Error&) {
        return solve_direct(system);
    }
}

SparseSolution solve_system(const SparseSystem& system, const Options& options) {
    SparseSolution solution = options.solver == Solver::direct      ? solve_direct(system)
                              : options.solver == Solver::iterative ? solve_iterative(system, options.tolerance, options.iteration_limit)
                                                                    : solve_automatically(system, options);
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
