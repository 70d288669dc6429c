#pragma once

#include <Eigen/Core>

namespace cleave::particles {

/// The spiky kernel with smoothing tensor G (1/m), Eq. 4: W = 15/pi det(G) (1 - |G r|)^3 for |G r| < 1, else 0. Unit 1/m^3.
/// The paper writes ||G|| in front: it must be the determinant for the integral of W to be one.
double kernel(const Eigen::Vector3d& r, const Eigen::Matrix3d& tensor);

/// Gradient of `kernel` with respect to r, Eq. 4: -45/pi det(G) G^2 r (1 - |G r|)^2 / |G r|, 1/m^4. Zero at r = 0, where the kernel
/// has a cusp: a particle never counts itself.
Eigen::Vector3d kernel_gradient(const Eigen::Vector3d& r, const Eigen::Matrix3d& tensor);

}  // namespace cleave::particles
