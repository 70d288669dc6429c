#pragma once

#include <Eigen/Eigenvalues>

#include <cmath>

namespace cleave::validation {

/// Largest principal value of a symmetric tensor: its direction (a crack's normal) and its gap to the second over the tensor's norm.
/// The study's own: the solver's stands in solver/fracture.
struct PrincipalDirection {
    Eigen::Vector3d direction;
    double gap;
};

inline PrincipalDirection principal_direction(const Eigen::Matrix3d& tensor) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(tensor);
    return {eigen.eigenvectors().col(2), (eigen.eigenvalues()[2] - eigen.eigenvalues()[1]) / tensor.norm()};
}

/// A direction counts as defined from this gap on.
inline constexpr double defined_gap = 0.2;

/// Angle between two lines, 0 to pi/2.
inline double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return std::acos(std::min(1.0, std::abs(a.dot(b)))); }

}  // namespace cleave::validation
