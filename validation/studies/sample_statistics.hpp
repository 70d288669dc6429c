#pragma once

#include <Eigen/Core>

#include <vector>

namespace cleave::validation {

/// A mean and the half width of its 95 % interval (Student's t; infinite for fewer than two values).
struct Estimate {
    double mean = 0, interval = 0;
};

Estimate estimate(const std::vector<double>& values);

/// Axes in a plane (angles modulo pi, rad): the mean and the spread by doubled angles, spread = sqrt(-2 ln R) / 2 with R the length of the
/// mean vector (Mardia and Jupp, Directional Statistics, 2000, Sect. 2.3); interval: 1.96 standard errors of the mean axis, from the scatter
/// of `vectors`, each the mean vector of doubled angles of one sample.
struct AxialEstimate {
    double mean = 0, spread = 0, interval = 0;
};

AxialEstimate axial_estimate(const std::vector<Eigen::Vector2d>& vectors);

/// (cos 2a, sin 2a) of an axis (x, y), not zero.
Eigen::Vector2d doubled(double x, double y);

}  // namespace cleave::validation
