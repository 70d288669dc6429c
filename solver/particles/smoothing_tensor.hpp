#pragma once

#include <Eigen/Core>

namespace cleave::particles {

/// G = I/h (1/m): the isotropic kernel of support radius h (m) > 0.
Eigen::Matrix3d isotropic_tensor(double support_radius);

/// G = R diag(1/h_k) R^T (Eq. 5): support radius h_k (m) > 0 along column k of the rotation R. The support |G r| < 1 is the ellipsoid
/// with these half axes.
Eigen::Matrix3d tensor_from_axes(const Eigen::Matrix3d& axes, const Eigen::Vector3d& support_radii);

/// The tensor of a body turned by M (x = M x0, Eq. 3): G = M G0 M^T. Eq. 6 prints M^T G0 M, which is right only where M maps the
/// current body to the one at rest; with Eq. 3's M it changes W by up to a third of W(0).
Eigen::Matrix3d rotated_tensor(const Eigen::Matrix3d& tensor, const Eigen::Matrix3d& rotation);

/// Half the edges (m) of the box around the support |G r| < 1, parallel to x, y, z.
Eigen::Vector3d support_box(const Eigen::Matrix3d& tensor);

}  // namespace cleave::particles
