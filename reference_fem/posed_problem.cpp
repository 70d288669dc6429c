#include "reference_fem/posed_problem.hpp"

#include "reference_fem/constraints.hpp"
#include "reference_fem/line_loads.hpp"
#include "reference_fem/nodal_forces.hpp"

#include <fmt/format.h>

namespace cleave::fem {
namespace {

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

/// The problem of a free body, held where it is convenient.
Problem held_without_force(Problem problem, const InertiaRelief& relief) {
    if (!problem.displacements.empty() || !problem.line_displacements.empty() || !problem.supports.empty())
        throw Error("a free body cannot have prescribed displacements");
    problem.supports = relief.supports();
    return problem;
}

Mesh checked_mesh(const std::string& path) {
    Mesh mesh = read_msh(path);
    check_cells(mesh);
    return mesh;
}

}  // namespace

PosedProblem::PosedProblem(const Problem& problem, const Options& options) {
    check_options(options);
    data_ = std::make_shared<Solution::Data>(checked_mesh(problem.mesh_file), options, problem.regions);
    const FaceTable faces(data_->mesh);
    load_ = nodal_loads(data_->space, problem.body_force, loads_of(problem, faces));
    add_line_loads(problem.line_loads, data_->mesh, faces, data_->space, load_);
    if (problem.free_body) relief_.emplace(*data_, problem.regions).balance(load_);
    prescribed_ = prescribe(relief_ ? held_without_force(problem, *relief_) : problem, data_->mesh, faces, data_->space);
}

Solution PosedProblem::conclude(std::vector<double> displacement, SolveRecord record, double seconds) {
    data_->displacement = std::move(displacement);
    if (relief_) relief_->remove_rigid_motion(data_->displacement);
    add_energies(*data_, load_, prescribed_);
    record.cells = static_cast<long>(data_->mesh.cells.size());
    record.dofs = data_->space.dofs();
    record.seconds = seconds;
    data_->record = record;
    return Solution(data_);
}

}  // namespace cleave::fem
