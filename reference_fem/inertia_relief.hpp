#pragma once

#include "reference_fem/solution_data.hpp"

#include <Eigen/Core>

#include <vector>

namespace cleave::fem {

/// A body that nothing holds, under loads that need not balance. It accelerates as a rigid body, a(x) = sum c_k r_k(x) with the six rigid
/// motions r_k; d'Alembert's body force -rho a(x) brings the loads into balance, and the body strains as if it were at rest.
/// Newton and Euler: sum_l (int rho r_k . r_l dV) c_l = work of the loads on r_k.
class InertiaRelief {
public:
    /// Throws Error without a positive density for each region, and for a body of several parts.
    InertiaRelief(const Solution::Data& data, const std::vector<Region>& regions);

    /// Adds the inertia forces: afterwards the loads do no work on any rigid motion.
    void balance(std::vector<double>& load) const;

    /// Six components that hold the body without force, since the loads are in balance: three at one vertex, two at the farthest from
    /// it, one at the farthest from the line through both.
    std::vector<Support> supports() const;

    /// Takes the rigid part out of a displacement: int rho r_k . u dV = 0 for all k.
    void remove_rigid_motion(std::vector<double>& displacement) const;

private:
    using Motions = Eigen::Matrix<double, Eigen::Dynamic, 6>;

    const Solution::Data& data_;
    Motions motions_;   // r_k at the nodes, by dof
    Motions momentum_;  // int rho phi r_k dV, by dof
    Eigen::Matrix<double, 6, 6> mass_;
};

}  // namespace cleave::fem
