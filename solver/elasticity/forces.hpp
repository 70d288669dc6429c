#pragma once

#include "solver/elasticity/strain.hpp"

#include <vector>

namespace cleave::elasticity {

/// Forces of pairs. The force on j by i, the derivative of i's energy, is f_ji = -V_i P_i d_ij (Eqs. 9 and 10) with one matrix P_i (Pa)
/// per particle; the laws below differ in P_i only. The force on i is F_i = sum_j (f_ij - f_ji), without the factor 1/2 that some
/// texts put there: f_ij comes from the energy of j, -f_ji from that of i, and both depend on the place of i.
///
/// Returns F (N) of every particle: the elastic force, -dU/du where the law is exact. Sum zero for every P.
std::vector<Eigen::Vector3d> pair_forces(const StrainOperator& op, const particles::Particles& particles,
                                         const std::vector<Eigen::Matrix3d>& pair_stress);

/// P = sigma: the exact derivative of Eq. 8 with the linear strain of Eq. 1.
std::vector<Eigen::Matrix3d> linear_pair_stress(const Fields& fields);

/// P = (I + grad u^T) sigma: Eq. 9 as printed, named `paper`. The factor does not belong to the linear strain: the force is 8 to 30 %
/// off where |grad u| is 0.2 to 0.45. (It is Green's strain that brings a factor, and then I + grad u in this index order.)
std::vector<Eigen::Matrix3d> paper_pair_stress(const Fields& fields);

/// Fields with Green's strain (J^T J - I)/2, J = I + grad u; `stress` is the second Piola-Kirchhoff stress S = C E (Pa).
Fields evaluate_green(const StrainOperator& op, const particles::Particles& particles, const Solid& solid,
                      const std::vector<Eigen::Vector3d>& displacement);

/// P = (I + grad u) S: the exact derivative of the energy of evaluate_green.
std::vector<Eigen::Matrix3d> green_pair_stress(const Fields& green);

}  // namespace cleave::elasticity
