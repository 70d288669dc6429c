#include "solver/elasticity/equilibrium_system.hpp"

#include "solver/elasticity/equilibrium_assembly.hpp"
#include "solver/elasticity/equilibrium_cg.hpp"
#include "solver/elasticity/equilibrium_coarse.hpp"
#include "solver/elasticity/equilibrium_loads.hpp"
#include "solver/elasticity/equilibrium_rigid.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleave::elasticity {

namespace {

Vectors total_force(const EquilibriumSystem& system, const Vectors& inertia) {
    Vectors force(system.external_force.size());
    for (std::size_t i = 0; i < force.size(); ++i) {
        force[i] = system.external_force[i] + system.nitsche_force[i];
        if (!inertia.empty()) force[i] -= inertia[i];
    }
    return force;
}

/// Particles per lump of the second level. Measured on the penny crack (residual 1e-8; iterations, seconds): 9.7k particles without it 207,
/// lumps of 60, 100, 200: 88, 108, 131; 62.5k particles without it 372, lumps of 100, 200, 400: 101, 127, 155 and 12, 4.3, 4.1 s, since the
/// factor of the coarse matrix grows faster than the lumps: at most about 400 of them.
int lump_size(int particles) { return std::max(100, particles / 400); }

void solve_by_cg(const EquilibriumSystem& system, const EquilibriumOptions& options, Vectors force, Vectors& displacement,
                 EquilibriumReport& report) {
    const GradientStencils stencils = gradient_stencils(*system.body);
    std::vector<Eigen::Matrix3d> inverse = diagonal_blocks(system.energy, stencils);
    const CoarseSpace coarse(system.energy, stencils, lump_size(system.body->particles.size()));
    parallel_for_each(static_cast<int>(inverse.size()), [&](int i) { inverse[i] = inverse[i].inverse().eval(); });
    StiffnessOperator stiffness(system.energy);
    LinearSystem linear;
    linear.apply = [&](const Vectors& u, Vectors& f) { stiffness.apply(u, f); };
    linear.precondition = [&](const Vectors& r, Vectors& z) {
        parallel_for_each(static_cast<int>(r.size()), [&](int i) { z[i] = inverse[i] * r[i]; });
        coarse.add_correction(r, z);
    };
    const RigidMotions rigid(system.body->particles.position, system.piece, std::vector<double>(force.size(), 1.0));
    if (system.energy.prescribed.empty()) {
        rigid.balance(force);  // takes out rounding: a free body's load is in balance
        linear.project = [&](Vectors& v) { rigid.balance(v); };
    }
    const CgResult result = conjugate_gradients(linear, force, displacement, options.tolerance, options.max_iterations);
    report.iterations = result.iterations;
    report.residual = result.residual;
}

double residual(const EquilibriumSystem& system, const Vectors& force, const Vectors& displacement) {
    StiffnessOperator stiffness(system.energy);
    Vectors rest;
    stiffness.apply(displacement, rest);
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = force[i] - rest[i];
    const double scale = dot(force, force);
    return scale > 0 ? std::sqrt(dot(rest, rest) / scale) : 0;
}

}  // namespace

double EquilibriumSystem::potential(const Vectors& displacement, const Vectors& inertia) const {
    StiffnessOperator stiffness(energy);
    Vectors force;
    stiffness.apply(displacement, force);
    return 0.5 * dot(displacement, force) - dot(displacement, total_force(*this, inertia)) + constant;
}

EquilibriumSystem make_system(const EquilibriumProblem& problem, double link_penalty, std::shared_ptr<const ConformingBody> body) {
    if (problem.free_body && !problem.displacements.empty()) {
        throw std::invalid_argument("a free body, or prescribed displacements, not both");
    }
    EquilibriumSystem system;
    system.body = std::move(body);
    system.surface = surface_ids(problem.mesh, system.body->faces);
    system.piece = connected_pieces(system.body->faces, system.body->particles.size());
    std::vector<PrescribedFace> prescribed = prescribed_faces(problem, *system.body, system.surface);
    if (!problem.free_body) check_held(*system.body, system.piece, prescribed);
    system.energy = make_energy(*system.body, link_penalty, std::move(prescribed));
    system.surface_loads = surface_loads(problem, *system.body, system.surface);
    system.external_force = external_forces(problem, *system.body, system.surface_loads);
    system.nitsche_force = nitsche_forces(system.energy);
    system.constant = nitsche_constant(system.energy);
    return system;
}

std::vector<double> masses(const EquilibriumProblem& problem, const particles::Particles& particles) {
    std::vector<double> mass;
    for (int i = 0; i < particles.size(); ++i) {
        const auto density = problem.density.find(particles.region[i]);
        mass.push_back(particles.volume[i] * (density == problem.density.end() ? 1.0 : density->second));
        if (!(mass.back() > 0)) throw std::invalid_argument("a positive density");
    }
    return mass;
}

Vectors inertia_forces(const EquilibriumProblem& problem, const EquilibriumSystem& system) {
    if (!problem.free_body) return {};
    const std::vector<double> mass = masses(problem, system.body->particles);
    Vectors inertia = RigidMotions(system.body->particles.position, system.piece, mass).response(system.external_force);
    for (std::size_t i = 0; i < inertia.size(); ++i) inertia[i] *= mass[i];
    return inertia;
}

double system_residual(const EquilibriumSystem& system, const Vectors& displacement) {
    return residual(system, total_force(system, {}), displacement);
}

void solve_system(const EquilibriumSystem& system, const EquilibriumOptions& options, const Vectors& inertia, Vectors& displacement,
                  EquilibriumReport& report) {
    const Vectors force = total_force(system, inertia);
    displacement.resize(force.size(), Eigen::Vector3d::Zero());
    if (options.solver == EquilibriumSolver::cholesky) {
        if (system.energy.prescribed.empty()) throw std::invalid_argument("conjugate gradients for a free body: its stiffness is singular");
        displacement = solve_by_cholesky(assemble_stiffness(system.energy), force);
        report.residual = residual(system, force, displacement);
        return;
    }
    solve_by_cg(system, options, force, displacement, report);
    // The recursion's residual and the true one part where K is so badly conditioned that rounding rules.
    if (report.iterations >= options.max_iterations || !(report.residual <= 100 * options.tolerance)) {
        throw NotConverged(fmt::format("equilibrium: residual {:.3g} after {} iterations, {:.3g} asked for", report.residual, report.iterations,
                                       options.tolerance));
    }
}

}  // namespace cleave::elasticity
