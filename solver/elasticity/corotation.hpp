#pragma once

#include "solver/elasticity/forces.hpp"

namespace cleave::elasticity {

/// Strain of a body that has also turned (Eq. 3): each particle's neighbourhood is turned back by the particle's rotation M_i, and
/// the linear strain is taken of what is left,
///
///   u_ji = M_i^T (x_j - x_i) - (x0_j - x0_i)
///
/// Kernels, moments and material axes stay at rest (x0, G0, C): M^T grad W(x_ij, G_t) with G_t = M G0 M^T is grad W(x0_ij, G0) for a
/// body that has only turned.
struct Corotation {
    std::vector<Eigen::Matrix3d> rotation;  ///< M_i
    Fields fields;                          ///< of the turned-back displacements, in the axes at rest
};

/// The rotation nearest to a deformation gradient (polar decomposition by singular values; det +1 also for an inverted one).
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& deformation);

/// M_i of every particle, from J = sum_j (x_j - x_i) d_ij^T of `op`, which has to be exact for linear fields: by the raw operator even
/// a body at rest would seem deformed by a third.
std::vector<Eigen::Matrix3d> rotations(const StrainOperator& op, const std::vector<Eigen::Vector3d>& position);

/// Fields of the body at `position` (m). `rotation_operator` gives the rotations: `corrected`, built for the same particles.
Corotation corotate(const StrainOperator& op, const StrainOperator& rotation_operator, const particles::Particles& at_rest,
                    const Solid& solid, const std::vector<Eigen::Vector3d>& position);

/// P = M sigma, for pair_forces: the derivative of the energy for isotropic C. For anisotropic C the change of M_i with the positions
/// counts too and is left out: 7e-5 of the force at |grad u| = 7e-4, 6 % at 0.4. Keep to small strains.
std::vector<Eigen::Matrix3d> corotated_pair_stress(const Corotation& state);

}  // namespace cleave::elasticity
