#pragma once

#include "solver/elasticity/equilibrium_parallel.hpp"

#include <Eigen/Core>

#include <vector>

namespace cleave::elasticity {

/// The six rigid motions of every connected piece of a body, in the inner product sum_i w_i u_i . v_i.
class RigidMotions {
public:
    /// `piece` numbers the pieces from 0, one entry per point; weights > 0 (mass for accelerations, one for a plain projection).
    RigidMotions(const Vectors& position, const std::vector<int>& piece, std::vector<double> weight);

    /// The rigid motion a of each piece with sum w_i a_i . v_i = sum f_i . v_i for every rigid v: with masses for weights the acceleration
    /// under the forces f.
    Vectors response(const Vectors& force) const;

    /// Takes the rigid part out of a force: f_i - w_i response(f)_i, without net force and torque on any piece.
    void balance(Vectors& force) const;

    /// Takes the rigid part out of a displacement, in the inner product of the weights.
    void remove_from(Vectors& displacement) const;

private:
    using Motion = Eigen::Matrix<double, 6, 1>;
    using Gram = Eigen::Matrix<double, 6, 6>;

    Eigen::Matrix<double, 3, 6> basis(int i) const;

    const Vectors& position_;
    const std::vector<int>& piece_;
    std::vector<double> weight_;
    std::vector<Eigen::Vector3d> centre_;
    std::vector<double> size_;  ///< m, makes rotations as large as translations
    std::vector<Gram> inverse_;
};

/// Columns: three translations and three rotations (1/m) about the origin, at x: u = R(x) m.
Eigen::Matrix<double, 3, 6> rigid_basis(const Eigen::Vector3d& x);

}  // namespace cleave::elasticity
