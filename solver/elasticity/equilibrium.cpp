#include "solver/elasticity/equilibrium.hpp"

#include "solver/elasticity/equilibrium_rigid.hpp"
#include "solver/elasticity/equilibrium_system.hpp"

#include <stdexcept>

namespace cleave::elasticity {

namespace {

std::vector<Eigen::Matrix3d> gradients(const ConformingBody& body, const Vectors& trace) {
    std::vector<Eigen::Matrix3d> gradient(body.particles.size());
    parallel_for_each(body.particles.size(), [&](int i) { gradient[i] = face_gradient(body, i, trace); });
    return gradient;
}

std::vector<BoundaryTrace> boundary_traces(const EquilibriumSystem& system, const Vectors& trace) {
    std::vector<BoundaryTrace> boundary;
    for (std::size_t f = 0; f < trace.size(); ++f) {
        const Face& face = system.body->faces.faces[f];
        if (face.is_boundary()) boundary.push_back({system.surface[f], face.centroid, face.area.normalized(), face.area.norm(), trace[f]});
    }
    return boundary;
}

}  // namespace

EquilibriumSolution solve_equilibrium(const EquilibriumProblem& problem, const EquilibriumOptions& options) {
    EquilibriumSolution solution;
    solution.body = std::make_shared<const ConformingBody>(make_conforming_body(problem.mesh, problem.stiffness, options.traces));
    const EquilibriumSystem system = make_system(problem, options.link_penalty, solution.body);
    const Vectors inertia = inertia_forces(problem, system);
    solution.report.traces = solution.body->stencils.report;
    solve_system(system, options, inertia, solution.displacement, solution.report);
    if (problem.free_body) {
        // The rigid motion of a free body is nobody's to know: its displacement is given without.
        const particles::Particles& particles = solution.body->particles;
        RigidMotions(particles.position, system.piece, particles.volume).remove_from(solution.displacement);
    }

    Vectors trace;
    face_displacements(*solution.body, solution.displacement, trace);
    solution.fields = fields_of_gradients(*solution.body, gradients(*solution.body, trace));
    solution.recovered = fields_of_gradients(*solution.body, smoothed_gradients(*solution.body, solution.fields.gradient));
    solution.boundary = boundary_traces(system, trace);
    solution.strain_energy = solution.fields.total_energy();
    solution.link_energy = link_energy(system.energy, solution.displacement);
    solution.external_work = dot(system.external_force, solution.displacement);
    solution.potential = system.potential(solution.displacement, inertia);
    const std::vector<double> mass = masses(problem, solution.body->particles);
    for (std::size_t i = 0; i < inertia.size(); ++i) solution.acceleration.push_back(inertia[i] / mass[i]);
    return solution;
}

double balance_residual(const EquilibriumProblem& problem, const Vectors& displacement, const EquilibriumOptions& options) {
    if (problem.free_body) throw std::invalid_argument("a held body: the balance of a free one needs its acceleration");
    auto body = std::make_shared<const ConformingBody>(make_conforming_body(problem.mesh, problem.stiffness, options.traces));
    const EquilibriumSystem system = make_system(problem, options.link_penalty, std::move(body));
    if (displacement.size() != system.external_force.size()) throw std::invalid_argument("one displacement per particle");
    return system_residual(system, displacement);
}

}  // namespace cleave::elasticity
