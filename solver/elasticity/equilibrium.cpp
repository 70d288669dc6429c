#include "solver/elasticity/equilibrium.hpp"

#include "solver/elasticity/equilibrium_rigid.hpp"
#include "solver/elasticity/equilibrium_system.hpp"

namespace cleave::elasticity {

namespace {

Fields fields_of(const ConformingBody& body, const Vectors& trace) {
    const int count = body.particles.size();
    Fields fields{std::vector<Eigen::Matrix3d>(count), std::vector<material::Voigt>(count), std::vector<material::Voigt>(count),
                  std::vector<double>(count)};
    parallel_for_each(count, [&](int i) {
        fields.gradient[i] = face_gradient(body, i, trace);
        fields.strain[i] = strain_of(fields.gradient[i]);
        fields.stress[i] = body.solid.of(i) * fields.strain[i];
        fields.energy[i] = strain_energy(body.particles.volume[i], fields.strain[i], fields.stress[i]);
    });
    return fields;
}

std::vector<BoundaryTrace> boundary_traces(const EquilibriumSystem& system, const Vectors& trace) {
    std::vector<BoundaryTrace> boundary;
    for (std::size_t f = 0; f < trace.size(); ++f) {
        const Face& face = system.body->faces.faces[f];
        if (face.is_boundary()) boundary.push_back({system.surface[f], face.centroid, face.area.normalized(), face.area.norm(), trace[f]});
    }
    return boundary;
}

/// The rigid motion of a free body is nobody's to know: its displacement is given without.
void remove_rigid_part(const EquilibriumSystem& system, Vectors& displacement) {
    RigidMotions(system.body->particles.position, system.piece, system.body->particles.volume).remove_from(displacement);
}

}  // namespace

EquilibriumSolution solve_equilibrium(const EquilibriumProblem& problem, const EquilibriumOptions& options) {
    EquilibriumSolution solution;
    solution.body = std::make_shared<const ConformingBody>(make_conforming_body(problem.mesh, problem.stiffness, options.traces));
    const EquilibriumSystem system = make_system(problem, options.link_penalty, solution.body);
    const Vectors inertia = inertia_forces(problem, system);
    solution.report.traces = solution.body->stencils.report;
    solve_system(system, options, inertia, solution.displacement, solution.report);
    if (problem.free_body) remove_rigid_part(system, solution.displacement);

    Vectors trace;
    face_displacements(*solution.body, solution.displacement, trace);
    solution.fields = fields_of(*solution.body, trace);
    solution.boundary = boundary_traces(system, trace);
    solution.strain_energy = solution.fields.total_energy();
    solution.link_energy = link_energy(system.energy, solution.displacement);
    solution.external_work = dot(system.external_force, solution.displacement);
    solution.potential = system.potential(solution.displacement, inertia);
    for (std::size_t i = 0; i < inertia.size(); ++i) {
        const auto density = problem.density.find(solution.body->particles.region[i]);
        const double mass = solution.body->particles.volume[i] * (density == problem.density.end() ? 1.0 : density->second);
        solution.acceleration.push_back(inertia[i] / mass);
    }
    return solution;
}

}  // namespace cleave::elasticity
