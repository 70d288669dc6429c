#include "solver/elasticity/relaxation.hpp"

#include "solver/elasticity/forces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleave::elasticity {

namespace {

using Vectors = std::vector<Eigen::Vector3d>;

void check(const RelaxationProblem& problem) {
    const auto count = static_cast<std::size_t>(problem.particles.size());
    if (problem.load.size() != count || problem.held.size() != count || problem.displacement.size() != count)
        throw std::invalid_argument("one load, one flag and one displacement per particle");
    if (std::find(problem.held.begin(), problem.held.end(), false) == problem.held.end())
        throw std::invalid_argument("a particle that is not held");
}

/// Elastic forces of a displacement, zero on the held particles.
Vectors elastic_forces(const RelaxationProblem& problem, const Vectors& displacement) {
    const Fields fields = evaluate(problem.op, problem.particles, problem.solid, displacement);
    Vectors force = pair_forces(problem.op, problem.particles, linear_pair_stress(fields));
    for (std::size_t i = 0; i < force.size(); ++i)
        if (problem.held[i]) force[i].setZero();
    return force;
}

/// Of the size of the diagonal of the stiffness (N/m): V_i C |d|^2 summed over the energies that a particle's displacement enters.
std::vector<double> masses(const RelaxationProblem& problem) {
    const int count = problem.particles.size();
    std::vector<double> mass(count, 0);
    for (int i = 0; i < count; ++i) {
        const double scale = problem.particles.volume[i] * problem.solid.of(i).diagonal().maxCoeff();
        Eigen::Vector3d own = Eigen::Vector3d::Zero();
        const auto neighbours = problem.op.neighbours.of(i);
        const auto weights = problem.op.weights_of(i);
        for (std::size_t n = 0; n < neighbours.size(); ++n) {
            own -= weights[n];
            mass[neighbours[n]] += scale * weights[n].squaredNorm();
        }
        mass[i] += scale * own.squaredNorm();
    }
    const double least = 1e-3 * *std::max_element(mass.begin(), mass.end());  // a particle without neighbours has none
    for (double& m : mass) m = std::max(m, least);
    return mass;
}

/// Largest eigenvalue of M^-1 K by power iteration; 60 rounds are within a few per cent, and the time step leaves more than that.
double largest_eigenvalue(const RelaxationProblem& problem, const std::vector<double>& mass) {
    Vectors mode(mass.size());
    for (std::size_t i = 0; i < mode.size(); ++i) {
        const double t = static_cast<double>(i);
        mode[i] = problem.held[i] ? Eigen::Vector3d::Zero() : Eigen::Vector3d(std::sin(1.7 * t + 0.3), std::sin(2.9 * t), std::cos(4.3 * t));
    }
    double eigenvalue = 0;
    for (int round = 0; round < 60; ++round) {
        double norm = 0;
        for (const Eigen::Vector3d& v : mode) norm += v.squaredNorm();
        for (Eigen::Vector3d& v : mode) v /= std::sqrt(norm);
        mode = elastic_forces(problem, mode);
        norm = 0;
        for (std::size_t i = 0; i < mode.size(); ++i) norm += (mode[i] /= -mass[i]).squaredNorm();
        eigenvalue = std::sqrt(norm);
    }
    return eigenvalue;
}

/// 2 omega (1/s) of the motion under way, omega^2 = du . K du / du . M du its Rayleigh quotient, du = velocity * step the last move.
double critical_damping(const Vectors& velocity, const Vectors& before, const Vectors& force, const std::vector<double>& mass, double step) {
    double stiff = 0, heavy = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        stiff += velocity[i].dot(before[i] - force[i]);
        heavy += mass[i] * velocity[i].squaredNorm();
    }
    return heavy > 0 ? 2 * std::sqrt(std::max(0.0, stiff / (step * heavy))) : 0;
}

double largest(const Vectors& vectors) {
    double size = 0;
    for (const Eigen::Vector3d& v : vectors) size = std::max(size, v.norm());
    return size;
}

}  // namespace

Relaxation relax(const RelaxationProblem& problem, const RelaxationOptions& options) {
    check(problem);
    const std::vector<double> mass = masses(problem);
    // Leapfrog is stable below 2 / omega; 0.8 of it covers what the power iteration misses.
    const double step = 1.6 / std::sqrt(largest_eigenvalue(problem, mass));
    Relaxation result{problem.displacement};
    Vectors velocity(mass.size(), Eigen::Vector3d::Zero()), before;
    double first = 0;
    for (;; ++result.steps) {
        Vectors force = elastic_forces(problem, result.displacement);
        for (std::size_t i = 0; i < force.size(); ++i)
            if (!problem.held[i]) force[i] += problem.load[i];
        if (result.steps == 0) first = largest(force);
        result.residual = first > 0 ? largest(force) / first : 0;
        if (result.residual <= options.tolerance || result.steps == options.max_steps) return result;
        const double damping = step * critical_damping(velocity, before, force, mass, step);
        for (std::size_t i = 0; i < force.size(); ++i) {
            velocity[i] = ((2 - damping) * velocity[i] + 2 * step / mass[i] * force[i]) / (2 + damping);
            result.displacement[i] += step * velocity[i];
        }
        before = std::move(force);
    }
}

}  // namespace cleave::elasticity
