#pragma once

#include <Eigen/Core>

namespace cleave::simulation {

/// The point of a triangle nearest to p, m (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
Eigen::Vector3d closest_point(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace cleave::simulation
