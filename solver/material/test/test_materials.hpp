#pragma once

#include "solver/material/stiffness.hpp"

#include <Eigen/Geometry>

#include <random>

namespace cleave::material::test {

/// T300/5208 as a full orthotropic set; Young's modulus at 45 degrees in the 1-2 plane is 16.74 GPa.
inline EngineeringConstants carbon_epoxy() {
    const double E2 = 10.3e9, nu23 = 0.47;
    return {181e9, E2, E2, E2 / (2 * (1 + nu23)), 7.17e9, 7.17e9, 0.28, 0.28, nu23};
}

/// A rotation drawn uniformly.
inline Eigen::Matrix3d random_rotation(std::mt19937& generator) {
    std::normal_distribution<double> normal;
    Eigen::Quaterniond q(normal(generator), normal(generator), normal(generator), normal(generator));
    return q.normalized().toRotationMatrix();
}

/// A stiffness with all 21 constants different from zero: A A^T plus a multiple of one, about 10 to 100 GPa.
inline Stiffness random_triclinic(std::mt19937& generator) {
    std::normal_distribution<double> normal;
    Stiffness a;
    for (int i = 0; i < 36; ++i) a(i) = normal(generator);
    const Stiffness c = 10e9 * (a * a.transpose() / 6 + Stiffness::Identity());
    return 0.5 * (c + c.transpose());
}

inline Eigen::Matrix3d random_matrix(std::mt19937& generator) {
    std::normal_distribution<double> normal;
    Eigen::Matrix3d m;
    for (int i = 0; i < 9; ++i) m(i) = normal(generator);
    return m;
}

}  // namespace cleave::material::test
