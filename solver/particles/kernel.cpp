#include "solver/particles/kernel.hpp"

#include <Eigen/LU>

#include <numbers>

namespace cleave::particles {

double kernel(const Eigen::Vector3d& r, const Eigen::Matrix3d& tensor) {
    const double q = (tensor * r).norm();
    if (q >= 1) return 0;
    const double rest = 1 - q;
    return 15 / std::numbers::pi * tensor.determinant() * rest * rest * rest;
}

Eigen::Vector3d kernel_gradient(const Eigen::Vector3d& r, const Eigen::Matrix3d& tensor) {
    const Eigen::Vector3d scaled = tensor * r;
    const double q = scaled.norm();
    if (q >= 1 || q == 0) return Eigen::Vector3d::Zero();
    const double rest = 1 - q;
    return -45 / std::numbers::pi * tensor.determinant() * rest * rest / q * (tensor * scaled);
}

}  // namespace cleave::particles
