#include "validation/adapters/force_checks.hpp"

#include "solver/elasticity/corotation.hpp"
#include "solver/elasticity/forces.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleave::validation {

namespace {

using Forces = std::vector<Eigen::Vector3d>;

double energy(const OperatorState& state, const Forces& displacement) {
    return elasticity::evaluate(state.op, state.particles, state.solid, displacement).total_energy();
}

Forces forces(const OperatorState& state, bool as_printed) {
    const elasticity::Fields fields = elasticity::evaluate(state.op, state.particles, state.solid, state.displacement);
    return elasticity::pair_forces(state.op, state.particles, as_printed ? elasticity::paper_pair_stress(fields) : elasticity::linear_pair_stress(fields));
}

double largest(const Forces& vectors) {
    double size = 0;
    for (const Eigen::Vector3d& v : vectors) size = std::max(size, v.norm());
    return size;
}

/// Largest |F + dU/du| over 20 particles and three components. The energy is quadratic in u: central differences with a large step
/// (the largest displacement) have no truncation error, only round-off.
double difference_error(const OperatorState& state, const Forces& force) {
    const std::size_t count = force.size(), stride = std::max<std::size_t>(1, count / 20);
    const double step = largest(state.displacement);
    double error = 0;
    for (std::size_t i = 0; i < count; i += stride)
        for (int k = 0; k < 3; ++k) {
            Forces plus = state.displacement, minus = state.displacement;
            plus[i][k] += step;
            minus[i][k] -= step;
            error = std::max(error, std::abs(force[i][k] + (energy(state, plus) - energy(state, minus)) / (2 * step)));
        }
    return error / largest(force);
}

double net_force(const Forces& force) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double size = 0;
    for (const Eigen::Vector3d& f : force) sum += f, size += f.norm();
    return sum.norm() / size;
}

double net_torque(const OperatorState& state, const Forces& force) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double size = 0;
    for (std::size_t i = 0; i < force.size(); ++i) {
        sum += state.particles.position[i].cross(force[i]);
        size += state.particles.position[i].norm() * force[i].norm();
    }
    return sum.norm() / size;
}

/// Corotated energy (Eq. 3) of the body as displaced, and of the same body turned by 1 rad about a skew axis.
double rotated_energy_error(const OperatorState& state) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
    Forces deformed = state.particles.position, turned;
    for (std::size_t i = 0; i < deformed.size(); ++i) {
        deformed[i] += state.displacement[i];
        turned.push_back(turn * deformed[i]);
    }
    const auto of = [&](const Forces& position) {
        return elasticity::corotate(state.op, state.op, state.particles, state.solid, position).fields.total_energy();
    };
    const double at_rest = of(deformed);
    return std::abs(of(turned) - at_rest) / at_rest;
}

}  // namespace

bool is_force_quantity(const std::string& quantity) {
    return quantity == "net_force" || quantity == "net_torque" || quantity == "force_error" || quantity == "force_error_as_printed" ||
           quantity == "rotated_energy_error";
}

double force_quantity(const OperatorState& state, const std::string& quantity) {
    if (quantity == "net_force") return net_force(forces(state, false));
    if (quantity == "net_torque") return net_torque(state, forces(state, false));
    if (quantity == "force_error") return difference_error(state, forces(state, false));
    if (quantity == "force_error_as_printed") return difference_error(state, forces(state, true));
    if (quantity == "rotated_energy_error") return rotated_energy_error(state);
    throw std::invalid_argument("a force quantity");
}

}  // namespace cleave::validation
