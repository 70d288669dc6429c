#include "solver/particles/smoothing_tensor.hpp"

#include <Eigen/LU>

namespace cleave::particles {

Eigen::Matrix3d isotropic_tensor(double support_radius) { return Eigen::Matrix3d::Identity() / support_radius; }

Eigen::Matrix3d tensor_from_axes(const Eigen::Matrix3d& axes, const Eigen::Vector3d& support_radii) {
    const Eigen::Matrix3d tensor = axes * support_radii.cwiseInverse().asDiagonal() * axes.transpose();
    return 0.5 * (tensor + tensor.transpose());
}

Eigen::Matrix3d rotated_tensor(const Eigen::Matrix3d& tensor, const Eigen::Matrix3d& rotation) {
    const Eigen::Matrix3d turned = rotation * tensor * rotation.transpose();
    return 0.5 * (turned + turned.transpose());
}

Eigen::Vector3d support_box(const Eigen::Matrix3d& tensor) {
    // max of r_a over |G r| <= 1 is the norm of row a of G^-1.
    return tensor.inverse().rowwise().norm();
}

}  // namespace cleave::particles
