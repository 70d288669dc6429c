#pragma once

#include "solver/contact/half_space.hpp"

#include <cmath>

namespace cleave::contact::test {

/// Gradient by central differences of fourth order with steps of `step` (m).
inline Eigen::Matrix3d differentiated(const HalfSpaceField& field, const Eigen::Vector3d& x, double step) {
    Eigen::Matrix3d gradient;
    for (int b = 0; b < 3; ++b) {
        const Eigen::Vector3d e = step * Eigen::Vector3d::Unit(b);
        gradient.col(b) = (8 * (field.displacement(x + e) - field.displacement(x - e)) -
                           (field.displacement(x + 2 * e) - field.displacement(x - 2 * e))) / (12 * step);
    }
    return gradient;
}

/// div sigma times `step`, over |sigma|.
inline double divergence(const HalfSpaceField& field, const Eigen::Vector3d& x, double step) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int b = 0; b < 3; ++b) {
        const Eigen::Vector3d e = step * Eigen::Vector3d::Unit(b);
        const material::Voigt difference = (8 * (field.stress(x + e) - field.stress(x - e)) - (field.stress(x + 2 * e) - field.stress(x - 2 * e))) / 12;
        sum += material::stress_from_voigt(difference).col(b);
    }
    return sum.norm() / field.stress(x).norm();
}

/// Gauss's rule on 0 to 1: calls of(x, weight) for its 16 points.
template <typename Function>
void gauss(const Function& of) {
    static constexpr double abscissa[8] = {0.0950125098376374, 0.2816035507792589, 0.4580167776572274, 0.6178762444026438,
                                           0.7554044083550030, 0.8656312023878318, 0.9445750230732326, 0.9894009349916499};
    static constexpr double weight[8] = {0.1894506104550685, 0.1826034150449236, 0.1691565193950025, 0.1495959888165767,
                                         0.1246289712555339, 0.0951585116824928, 0.0622535239386479, 0.0271524594117541};
    for (int i = 0; i < 8; ++i)
        for (const double side : {-1.0, 1.0}) of(0.5 * (1 + side * abscissa[i]), 0.5 * weight[i]);
}

/// Force (N) that the half-space below a hemisphere of radius R about the contact passes on: -integral of sigma n over it, n outward.
/// Gauss's rule in the cosine of the polar angle, equal steps in azimuth.
inline Eigen::Vector3d force_through_hemisphere(const HalfSpaceField& field, double radius, int azimuths = 48) {
    const Eigen::Matrix3d axes = surface_axes(field.load().inward);
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    gauss([&](double cosine, double weight) {
        const double sine = std::sqrt(1 - cosine * cosine), area = weight * 2 * M_PI / azimuths * radius * radius;
        for (int k = 0; k < azimuths; ++k) {
            const double phi = 2 * M_PI * k / azimuths;
            const Eigen::Vector3d n = axes * Eigen::Vector3d(sine * std::cos(phi), sine * std::sin(phi), cosine);
            force -= area * (material::stress_from_voigt(field.stress(field.load().point + radius * n)) * n);
        }
    });
    return force;
}

/// Displacement of Hertz's pressure over an ellipse (half axes a along `along`, b across, normal z) as a sum of point forces: rings
/// r = sqrt(1 - t^2) with t by Gauss's rule, 3 t^2 dt of the force each, and 48 spokes.
template <typename PointForce>
Eigen::Vector3d superposed(const PointForce& displacement_of, double a, double b, const Eigen::Vector3d& along) {
    const Eigen::Vector3d across = Eigen::Vector3d::UnitZ().cross(along);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    gauss([&](double t, double weight) {
        const double r = std::sqrt(1 - t * t);
        for (int k = 0; k < 48; ++k) {
            const double phi = 2 * M_PI * (k + 0.5) / 48;
            sum += displacement_of(a * r * std::cos(phi) * along + b * r * std::sin(phi) * across, 3 * t * t * weight / 48);
        }
    });
    return sum;
}

}  // namespace cleave::contact::test
