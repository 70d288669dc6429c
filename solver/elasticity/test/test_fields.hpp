#pragma once

#include "solver/elasticity/strain.hpp"
#include "solver/particles/test/box_mesh.hpp"

#include <cmath>
#include <vector>

namespace cleave::elasticity::test {

using particles::Particles;
using particles::test::box_mesh;
using particles::test::is_inner;

/// A displacement field with its gradient, both exact.
struct Field {
    std::function<Eigen::Vector3d(const Eigen::Vector3d&)> value;
    std::function<Eigen::Matrix3d(const Eigen::Vector3d&)> gradient;
};

inline std::vector<Eigen::Vector3d> sample(const Field& field, const Particles& particles) {
    std::vector<Eigen::Vector3d> values;
    for (const Eigen::Vector3d& x : particles.position) values.push_back(field.value(x));
    return values;
}

inline Field linear_field() {
    Eigen::Matrix3d a;
    a << 1.3, -0.7, 0.4, 0.9, -1.1, 0.6, -0.5, 0.8, 1.7;
    const Eigen::Vector3d b(0.3, -2, 5);
    return {[=](const Eigen::Vector3d& x) -> Eigen::Vector3d { return a * x + b; }, [=](const Eigen::Vector3d&) { return a; }};
}

/// u_a = x . Q_a x / 2 + A x: all eighteen second derivatives at work.
inline Field quadratic_field() {
    std::array<Eigen::Matrix3d, 3> q;
    q[0] << 1.2, 0.4, -0.7, 0.4, -0.9, 0.5, -0.7, 0.5, 0.8;
    q[1] << -0.6, 0.9, 0.2, 0.9, 1.1, -0.3, 0.2, -0.3, 0.7;
    q[2] << 0.5, -0.8, 0.6, -0.8, 0.4, 1.0, 0.6, 1.0, -1.3;
    const Field linear = linear_field();
    return {[=](const Eigen::Vector3d& x) -> Eigen::Vector3d {
                return linear.value(x) + 0.5 * Eigen::Vector3d(x.dot(q[0] * x), x.dot(q[1] * x), x.dot(q[2] * x));
            },
            [=](const Eigen::Vector3d& x) -> Eigen::Matrix3d {
                Eigen::Matrix3d gradient = linear.gradient(x);
                for (int a = 0; a < 3; ++a) gradient.row(a) += (q[a] * x).transpose();
                return gradient;
            }};
}

/// u_a = c_a sin(k_a . x + p_a): smooth, all nine gradients at work.
inline Field smooth_field() {
    Eigen::Matrix3d k;
    k << 2.1, 1.2, -0.8, -1.0, 2.3, 1.1, 0.9, -1.3, 2.0;
    const Eigen::Vector3d c(1, 0.8, 1.2), p(0.3, 1.1, -0.4);
    const auto phase = [=](const Eigen::Vector3d& x) -> Eigen::Vector3d { return k * x + p; };
    return {[=](const Eigen::Vector3d& x) -> Eigen::Vector3d { return c.array() * phase(x).array().sin(); },
            [=](const Eigen::Vector3d& x) -> Eigen::Matrix3d {
                return (c.array() * phase(x).array().cos()).matrix().asDiagonal() * k;
            }};
}

/// rms error of the gradients over rms gradient, of the particles that `counts` (all where empty).
inline double gradient_error(const StrainOperator& op, const Particles& particles, const Field& field,
                             const std::function<bool(const Eigen::Vector3d&)>& counts = {}) {
    const auto gradients = displacement_gradients(op, sample(field, particles));
    double error = 0, scale = 0;
    for (int i = 0; i < particles.size(); ++i) {
        const Eigen::Vector3d& x = particles.position[i];
        if (counts && !counts(x)) continue;
        error += (gradients[i] - field.gradient(x)).squaredNorm();
        scale += field.gradient(x).squaredNorm();
    }
    return std::sqrt(error / scale);
}

/// Largest error of any gradient.
inline double worst_gradient_error(const StrainOperator& op, const Particles& particles, const Field& field) {
    const auto gradients = displacement_gradients(op, sample(field, particles));
    double worst = 0;
    for (int i = 0; i < particles.size(); ++i)
        worst = std::max(worst, (gradients[i] - field.gradient(particles.position[i])).norm());
    return worst;
}

/// Slope of log(error) over log(size), least squares.
inline double order(const std::vector<double>& size, const std::vector<double>& error) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const double n = static_cast<double>(size.size());
    for (std::size_t i = 0; i < size.size(); ++i) {
        const double x = std::log(size[i]), y = std::log(error[i]);
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace cleave::elasticity::test
