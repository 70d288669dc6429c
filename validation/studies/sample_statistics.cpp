#include "validation/studies/sample_statistics.hpp"

#include <cmath>
#include <limits>

namespace cleave::validation {

namespace {

/// 97.5 % point of Student's t: Cornish and Fisher's expansion (Abramowitz and Stegun 26.7.5), to 1e-3 from 6 degrees of freedom on.
double student(double freedom) {
    const double z = 1.959963985;
    const double first = (std::pow(z, 3) + z) / 4, second = (5 * std::pow(z, 5) + 16 * std::pow(z, 3) + 3 * z) / 96;
    const double third = (3 * std::pow(z, 7) + 19 * std::pow(z, 5) + 17 * std::pow(z, 3) - 15 * z) / 384;
    return z + first / freedom + second / (freedom * freedom) + third / std::pow(freedom, 3);
}

}  // namespace

Estimate estimate(const std::vector<double>& values) {
    const double count = static_cast<double>(values.size());
    if (values.size() < 2) return {values.empty() ? 0 : values.front(), std::numeric_limits<double>::infinity()};
    double mean = 0, squares = 0;
    for (const double value : values) mean += value / count;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return {mean, student(count - 1) * std::sqrt(squares / (count - 1) / count)};
}

Eigen::Vector2d doubled(double x, double y) { return Eigen::Vector2d(x * x - y * y, 2 * x * y) / (x * x + y * y); }

AxialEstimate axial_estimate(const std::vector<Eigen::Vector2d>& vectors) {
    const double count = static_cast<double>(vectors.size()), infinite = std::numeric_limits<double>::infinity();
    if (vectors.size() < 2) return {0, infinite, infinite};
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& vector : vectors) mean += vector / count;
    const double length = mean.norm();
    if (!(length > 0)) return {0, infinite, infinite};
    // The mean's doubled angle errs by the scatter across it, over its length.
    const Eigen::Vector2d across(-mean.y() / length, mean.x() / length);
    double squares = 0;
    for (const Eigen::Vector2d& vector : vectors) squares += std::pow(across.dot(vector), 2);
    return {0.5 * std::atan2(mean.y(), mean.x()), 0.5 * std::sqrt(-2 * std::log(std::min(length, 1.0))),
            0.5 * 1.96 * std::sqrt(squares / (count - 1) / count) / length};
}

}  // namespace cleave::validation
