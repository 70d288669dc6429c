#include "validation/studies/kernel_properties.hpp"

#include "solver/particles/kernel.hpp"
#include "solver/particles/smoothing_tensor.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace cleave::validation {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using particles::kernel;
using std::numbers::pi;

constexpr double support_radius = 0.3;  // m; any

/// Determinant of an isotropic kernel of that radius; the longest axis is `aspect` times the others; askew.
Matrix3d tensor_of_aspect(double aspect) {
    const Matrix3d axes = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    const double across = support_radius / std::cbrt(aspect);
    return particles::tensor_from_axes(axes, {aspect * across, across, across});
}

/// Gauss-Legendre nodes and weights on (-1, 1), by Newton's iteration on the three-term recurrence.
std::vector<std::pair<double, double>> gauss(int count) {
    std::vector<std::pair<double, double>> rule;
    for (int i = 0; i < count; ++i) {
        double x = std::cos(pi * (i + 0.75) / (count + 0.5)), slope = 0;
        for (int iteration = 0; iteration < 50; ++iteration) {
            double before = 1, value = x;
            for (int k = 2; k <= count; ++k) before = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
            slope = count * (before - x * value) / (1 - x * x);
            const double step = value / slope;
            x -= step;
            if (std::abs(step) < 1e-15) break;
        }
        rule.emplace_back(x, 2 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

/// Integral of W in spherical coordinates about the particle: directions by Gauss in cos(theta) and equal steps in phi, and along each,
/// where W is a polynomial of degree 3 times r^2, Gauss to the end of the support.
double integral(const Matrix3d& tensor) {
    const auto polar = gauss(120), radial = gauss(4);
    constexpr int turns = 240;
    double sum = 0;
    for (const auto& [cosine, polar_weight] : polar)
        for (int turn = 0; turn < turns; ++turn) {
            const double phi = 2 * pi * turn / turns, sine = std::sqrt(1 - cosine * cosine);
            const Vector3d direction(sine * std::cos(phi), sine * std::sin(phi), cosine);
            const double reach = 1 / (tensor * direction).norm();
            for (const auto& [t, radial_weight] : radial) {
                const double r = reach * (t + 1) / 2;
                sum += polar_weight * 2 * pi / turns * radial_weight * reach / 2 * r * r * kernel(r * direction, tensor);
            }
        }
    return sum;
}

/// Points inside the support, off its centre and its rim, where W is smooth.
std::vector<Vector3d> probes(const Matrix3d& tensor) {
    std::vector<Vector3d> points;
    for (int i = 1; i <= 20; ++i) {
        const Vector3d direction = Vector3d(std::sin(3.1 * i), std::cos(1.7 * i), std::sin(0.9 * i + 1)).normalized();
        points.push_back((0.1 + 0.04 * i) / (tensor * direction).norm() * direction);
    }
    return points;
}

/// Largest |grad W - central difference| over the largest |grad W|.
double gradient_error(const Matrix3d& tensor) {
    const double step = 1e-5 * support_radius;
    double worst = 0, largest = 0;
    for (const Vector3d& r : probes(tensor)) {
        Vector3d difference;
        for (int k = 0; k < 3; ++k) {
            const Vector3d move = step * Vector3d::Unit(k);
            difference[k] = (kernel(r + move, tensor) - kernel(r - move, tensor)) / (2 * step);
        }
        const Vector3d gradient = particles::kernel_gradient(r, tensor);
        worst = std::max(worst, (gradient - difference).norm());
        largest = std::max(largest, gradient.norm());
    }
    return worst / largest;
}

/// Largest change of W over W(0) when the distance turns with the body and the kernel's tensor is `turned`.
double rotation_error(const Matrix3d& tensor, const Matrix3d& rotation, const Matrix3d& turned) {
    double worst = 0;
    for (const Vector3d& r : probes(tensor)) worst = std::max(worst, std::abs(kernel(rotation * r, turned) - kernel(r, tensor)));
    return worst / kernel(Vector3d::Zero(), tensor);
}

/// G = I/h against the isotropic spiky kernel 15/(pi h^6) (h - r)^3 (Desbrun and Gascuel 1996), over W(0).
double isotropic_limit_error() {
    const double h = support_radius;
    const Matrix3d tensor = particles::isotropic_tensor(h);
    double worst = 0;
    for (const Vector3d& r : probes(tensor))
        worst = std::max(worst, std::abs(kernel(r, tensor) - 15 / (pi * std::pow(h, 6)) * std::pow(h - r.norm(), 3)));
    return worst / kernel(Vector3d::Zero(), tensor);
}

class KernelProperties final : public Study {
public:
    StudyOutcome run(const StudyContext&) const override {
        StudyOutcome outcome;
        const Matrix3d rotation = Eigen::AngleAxisd(1.1, Vector3d(-1, 0.5, 2).normalized()).toRotationMatrix();
        for (const double aspect : {1.0, 4.0, 10.0}) {
            const Matrix3d tensor = tensor_of_aspect(aspect);
            const Matrix3d right = particles::rotated_tensor(tensor, rotation);
            const Matrix3d printed = rotation.transpose() * tensor * rotation;
            const std::string place = fmt::format("aspect {}", aspect);
            outcome.values.push_back({"kernel_integral", "solver", place, integral(tensor)});
            outcome.values.push_back({"kernel_gradient_error", "solver", place, gradient_error(tensor)});
            outcome.values.push_back({"kernel_rotation_error", "solver", place, rotation_error(tensor, rotation, right)});
            outcome.values.push_back({"kernel_rotation_error", "paper", place, rotation_error(tensor, rotation, printed)});
        }
        outcome.values.push_back({"kernel_isotropic_error", "solver", "aspect 1", isotropic_limit_error()});
        return outcome;
    }
};

}  // namespace

StudyInfo kernel_properties_study() {
    return {"kernel_properties",
            "the kernel of Eq. 4: unit integral, gradient, rotation (Eq. 6 right and as printed), isotropic limit",
            {},
            {{"kernel_integral", dimension::none}, {"kernel_gradient_error", dimension::none}, {"kernel_rotation_error", dimension::none},
             {"kernel_isotropic_error", dimension::none}},
            {"solver", "paper"},
            [](TableReader&) -> std::shared_ptr<const Study> { return std::make_shared<KernelProperties>(); }};
}

}  // namespace cleave::validation
