#pragma once

#include "solver/contact/isotropic_half_space.hpp"

#include <Eigen/Core>

namespace cleave::contact {

/// Distance in radii from which on Hertz's pressure is three point sources, one at the centre and a pair at the depths +- i sqrt(3/7) a:
/// Gauss's rule of the weight 1 - s^2 (isotropic_half_space.cpp), which leaves 0.01 (a/R)^6, where the closed form costs more and loses
/// (R/a)^3 of its digits.
inline constexpr double far_radii = 8;

/// Always true of a point force.
bool is_far(const IsotropicContact& contact, const Eigen::Vector3d& position);

/// Displacements (m) of four far places at once, a column each, z >= 0.
Eigen::Matrix<double, 3, 4> far_displacements(const IsotropicContact& contact, const Eigen::Matrix<double, 3, 4>& positions);

}  // namespace cleave::contact
