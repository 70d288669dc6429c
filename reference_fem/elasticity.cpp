#include "reference_fem/elasticity.hpp"

#include "reference_fem/constraints.hpp"
#include "reference_fem/inertia_relief.hpp"
#include "reference_fem/line_loads.hpp"
#include "reference_fem/nodal_forces.hpp"
#include "reference_fem/solution_data.hpp"
#include "reference_fem/vector3.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>

namespace cleave::fem {
namespace {

using Clock = std::chrono::steady_clock;

void check_options(const Options& options) {
    if (options.degree != 1 && options.degree != 2) throw Error(fmt::format("the degree must be 1 or 2, not {}", options.degree));
    if (!(options.tolerance > 0)) throw Error("the solver's tolerance must be positive");
    if (!(options.outside_tolerance >= 0 && options.outside_tolerance <= 1)) throw Error("the tolerance for outside points must be 0 to 1");
}

std::vector<SurfaceLoad> loads_of(const Problem& problem, const FaceTable& faces) {
    std::vector<SurfaceLoad> loads;
    for (const Traction& traction : problem.tractions) {
        if (!traction.value && !traction.stress) throw Error(fmt::format("surface {}: a traction without a value", traction.surface));
        if (traction.value && traction.stress) throw Error(fmt::format("surface {}: a traction with both value and stress", traction.surface));
        loads.push_back({.faces = faces.surface(traction.surface), .traction = traction.value, .stress = traction.stress, .pressure = 0});
    }
    for (const Pressure& pressure : problem.pressures)
        loads.push_back({.faces = faces.surface(pressure.surface), .traction = {}, .stress = {}, .pressure = pressure.value});
    return loads;
}

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

/// The problem of a free body, held where it is convenient.
Problem held_without_force(Problem problem, const InertiaRelief& relief) {
    if (!problem.displacements.empty() || !problem.line_displacements.empty() || !problem.supports.empty())
        throw Error("a free body cannot have prescribed displacements");
    problem.supports = relief.supports();
    return problem;
}

}  // namespace

Solution solve(const Problem& problem, const Options& options) {
    const Clock::time_point start = Clock::now();
    check_options(options);
    Mesh mesh = read_msh(problem.mesh_file);
    check_cells(mesh);
    const auto data = std::make_shared<Solution::Data>(std::move(mesh), options, problem.regions);
    const FaceTable faces(data->mesh);
    std::vector<double> load = nodal_loads(data->space, problem.body_force, loads_of(problem, faces));
    add_line_loads(problem.line_loads, data->mesh, faces, data->space, load);
    std::optional<InertiaRelief> relief;
    if (problem.free_body) relief.emplace(*data, problem.regions).balance(load);
    const PrescribedValues prescribed =
        prescribe(relief ? held_without_force(problem, *relief) : problem, data->mesh, faces, data->space);
    const Assembly assembly = assemble(data->space, data->materials, load, prescribed);
    const SparseSolution solution = solve_system(assembly.system, options);
    data->displacement = gather(assembly, prescribed, solution.values, data->space.dofs());
    if (relief) relief->remove_rigid_motion(data->displacement);
    add_energies(*data, load, prescribed);
    data->record = {.cells = static_cast<long>(data->mesh.cells.size()),
                    .dofs = data->space.dofs(),
                    .solver = solution.solver,
                    .iterations = solution.iterations,
                    .relative_residual = solution.relative_residual,
                    .seconds = std::chrono::duration<double>(Clock::now() - start).count(),
                    .matrix_bytes = solution.bytes};
    return Solution(data);
}

}  // namespace cleave::fem
