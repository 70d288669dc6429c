#include "solver/elasticity/crack_tip_field.hpp"

#include <Eigen/LU>
#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cleave::elasticity {

namespace {

using std::numbers::pi;
constexpr int intervals = 360;  // even: an angle of zero is a node; cubic interpolation between them errs by 1e-9

/// (ab)_ik = C_ijkl a_j b_l for a, b in the plane normal to the front.
Eigen::Matrix3d contraction(const material::Stiffness& c, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    static constexpr std::array<std::array<int, 3>, 2> voigt{{{0, 5, 4}, {5, 1, 3}}};  // of (j, i)
    Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 2; ++j)
                for (int l = 0; l < 2; ++l) result(i, k) += c(voigt[j][i], voigt[l][k]) * a[j] * b[l];
    return result;
}

}  // namespace

CrackTipField::CrackTipField(const material::Stiffness& stiffness) : scaled_(stiffness / stiffness(3, 3)), scale_(stiffness(3, 3)) {
    // Integral of N over each interval by Gauss and Legendre's three points, summed from zero outwards.
    const double width = 2 * pi / intervals, reach = width / 2 * std::sqrt(0.6);
    const auto integral = [&](double middle) -> Matrix6 {
        return width / 18 * (5 * fundamental(middle - reach) + 8 * fundamental(middle) + 5 * fundamental(middle + reach));
    };
    std::vector<Matrix6> turned(intervals + 1, Matrix6::Zero());
    for (int n = intervals / 2; n < intervals; ++n) turned[n + 1] = turned[n] + integral((n + 0.5) * width - pi);
    for (int n = intervals / 2; n > 0; --n) turned[n - 1] = turned[n] - integral((n - 0.5) * width - pi);
    for (Matrix6& each : turned) each = (0.5 * each).exp().eval();

    const Matrix6& end = turned.back();
    const Eigen::Matrix3d M = -end.bottomLeftCorner<3, 3>().inverse() * end.bottomRightCorner<3, 3>();
    compliance_ = (end.topLeftCorner<3, 3>() * M + end.topRightCorner<3, 3>()) / scale_;
    Shape start;
    start << M, Eigen::Matrix3d::Identity();
    for (const Matrix6& each : turned) shapes_.push_back(each * start);
}

CrackTipField::Matrix6 CrackTipField::fundamental(double angle) const {
    const Eigen::Vector2d m(std::cos(angle), std::sin(angle)), n(-m[1], m[0]);
    const Eigen::Matrix3d Q = contraction(scaled_, m, m), R = contraction(scaled_, m, n), inverse = contraction(scaled_, n, n).inverse();
    Matrix6 N;
    N << -inverse * R.transpose(), inverse, R * inverse * R.transpose() - Q, -R * inverse;
    return N;
}

/// Cubic between the nodes: the slope of a shape is N / 2 times it.
CrackTipField::Shape CrackTipField::shape(double angle) const {
    const double width = 2 * pi / intervals, position = std::clamp((angle + pi) / width, 0.0, double(intervals));
    const int node = std::min(static_cast<int>(position), intervals - 1);
    const double t = position - node, s = 1 - t;
    const auto slope = [&](int at) -> Shape { return width / 2 * fundamental(at * width - pi) * shapes_[at]; };
    return s * s * (1 + 2 * t) * shapes_[node] + t * t * (1 + 2 * s) * shapes_[node + 1] + s * s * t * slope(node) - t * t * s * slope(node + 1);
}

std::array<Eigen::Matrix3d, 3> CrackTipField::gradients(double x1, double x2) const {
    const double r = std::hypot(x1, x2), angle = std::atan2(x2, x1), c = std::cos(angle), s = std::sin(angle);
    const Shape here = shape(angle), turn = 0.5 * fundamental(angle) * here;
    const double size = std::sqrt(2 / (pi * r)) / scale_;
    std::array<Eigen::Matrix3d, 3> gradient;
    for (int mode = 0; mode < 3; ++mode) {
        const Eigen::Vector3d outward = size / 2 * here.col(mode).head<3>(), around = size * turn.col(mode).head<3>();
        gradient[mode].col(0) = c * outward - s * around;
        gradient[mode].col(1) = s * outward + c * around;
        gradient[mode].col(2).setZero();
    }
    return gradient;
}

}  // namespace cleave::elasticity
