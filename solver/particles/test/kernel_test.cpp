#include "solver/particles/kernel.hpp"
#include "solver/particles/smoothing_tensor.hpp"
#include "solver/particles/test/box_mesh.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace cleave::particles {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Kernel = std::function<double(const Vector3d&, const Matrix3d&)>;

struct Quadrature {
    Eigen::VectorXd node, weight;
};

/// Gauss-Legendre on [-1, 1] (Golub and Welsch 1969).
Quadrature gauss(int n) {
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(n, n);
    for (int k = 1; k < n; ++k) jacobi(k, k - 1) = jacobi(k - 1, k) = k / std::sqrt(4.0 * k * k - 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobi);
    return {solver.eigenvalues(), 2 * solver.eigenvectors().row(0).array().square().transpose()};
}

/// Integral of a kernel over space, ray by ray: polynomials of degree 5 along each ray (exact with 4 nodes), a smooth function of
/// the ray's direction (spectral convergence; 128 x 256 directions leave 1e-12 at aspect 4).
double integral(const Kernel& w, const Matrix3d& tensor) {
    const Quadrature polar = gauss(128), radial = gauss(4);
    double sum = 0;
    for (int p = 0; p < 128; ++p)
        for (int a = 0; a < 256; ++a) {
            const double z = polar.node[p], s = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * a / 256;
            const Vector3d n(s * std::cos(phi), s * std::sin(phi), z);
            const double length = 1 / (tensor * n).norm();
            for (int k = 0; k < 4; ++k) {
                const double r = 0.5 * length * (1 + radial.node[k]);
                sum += polar.weight[p] * 2 * std::numbers::pi / 256 * 0.5 * length * radial.weight[k] * r * r * w(r * n, tensor);
            }
        }
    return sum;
}

/// In the cube [-half, half]^3.
Vector3d random_point(std::mt19937& generator, double half) {
    std::uniform_real_distribution<double> uniform(-half, half);
    return {uniform(generator), uniform(generator), uniform(generator)};
}

/// Largest error of the gradient against central differences, over the largest gradient seen.
double gradient_error(const Matrix3d& tensor, std::mt19937& generator) {
    const Matrix3d inverse = tensor.inverse();
    const double step = 1e-5 * inverse.norm();
    double error = 0, scale = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Vector3d y = random_point(generator, 1);
        if (y.norm() < 0.05 || std::abs(y.norm() - 1) < 1e-3) continue;  // the cusp, and the edge of the support
        const Vector3d r = inverse * y;
        Vector3d difference;
        for (int a = 0; a < 3; ++a)
            difference[a] = (kernel(r + step * Vector3d::Unit(a), tensor) - kernel(r - step * Vector3d::Unit(a), tensor)) / (2 * step);
        error = std::max(error, (kernel_gradient(r, tensor) - difference).norm());
        scale = std::max(scale, difference.norm());
    }
    return error / scale;
}

/// The property suite of one kernel tensor: compact support, unit integral, gradient, rotation.
void expect_kernel_properties(const Matrix3d& tensor) {
    std::mt19937 generator(3);
    const Matrix3d inverse = tensor.inverse();
    for (const double q : {1.0, 1.0001, 2.0}) {
        const Vector3d r = inverse * (q * Vector3d(0.6, 0, 0.8) * 1.0000001);
        EXPECT_EQ(kernel(r, tensor), 0);
        EXPECT_EQ(kernel_gradient(r, tensor), Vector3d::Zero());
    }
    EXPECT_GT(kernel(inverse * Vector3d(0.59, 0, 0.8), tensor), 0);
    EXPECT_EQ(kernel_gradient(Vector3d::Zero(), tensor), Vector3d::Zero());
    EXPECT_NEAR(integral(kernel, tensor), 1, 1e-10);
    EXPECT_LT(gradient_error(tensor, generator), 1e-5);
    const double top = kernel(Vector3d::Zero(), tensor);
    for (int trial = 0; trial < 20; ++trial) {
        const Matrix3d turn = test::random_rotation(generator);
        const Vector3d r = inverse * random_point(generator, 0.5);
        EXPECT_NEAR(kernel(turn * r, rotated_tensor(tensor, turn)), kernel(r, tensor), 1e-13 * top);
    }
}

Matrix3d stretched(double a, double b, double c) {
    std::mt19937 generator(4);
    return tensor_from_axes(test::random_rotation(generator), {a, b, c});
}

TEST(Kernel, PropertiesOfTheIsotropicKernel) { expect_kernel_properties(isotropic_tensor(0.37)); }
TEST(Kernel, PropertiesOfAWireKernel) { expect_kernel_properties(stretched(0.8, 0.2, 0.2)); }
TEST(Kernel, PropertiesOfAPlateKernel) { expect_kernel_properties(stretched(0.8, 0.8, 0.3)); }
TEST(Kernel, PropertiesOfAGeneralKernel) { expect_kernel_properties(stretched(1.1, 0.5, 0.3)); }

/// Must-fail twin of the integral: the norm that the paper's || || suggests, in place of the determinant.
TEST(Kernel, TheNormInPlaceOfTheDeterminantIsSeen) {
    const Kernel printed = [](const Vector3d& r, const Matrix3d& g) { return kernel(r, g) / g.determinant() * g.norm(); };
    EXPECT_GT(std::abs(integral(printed, stretched(0.8, 0.2, 0.2)) - 1), 0.1);
}

TEST(Kernel, IsotropicLimit) {
    const double h = 0.4;
    const Vector3d r(0.1, -0.2, 0.05);
    const double q = r.norm() / h;
    EXPECT_NEAR(kernel(r, isotropic_tensor(h)), 15 / (std::numbers::pi * h * h * h) * std::pow(1 - q, 3), 1e-13);
    const Vector3d gradient = -45 / (std::numbers::pi * std::pow(h, 4)) * std::pow(1 - q, 2) * r.normalized();
    EXPECT_LT((kernel_gradient(r, isotropic_tensor(h)) - gradient).norm(), 1e-11);
    EXPECT_LT((tensor_from_axes(Matrix3d::Identity(), {h, h, h}) - isotropic_tensor(h)).norm(), 1e-15);
}

/// Eq. 6 as printed, M^T G M, with Eq. 3's M: W changes by up to a third of W(0).
TEST(SmoothingTensor, ThePrintedRotationIsWrong) {
    std::mt19937 generator(5);
    const Matrix3d tensor = stretched(0.8, 0.2, 0.2);
    double worst = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const Matrix3d turn = test::random_rotation(generator);
        const Vector3d r = tensor.inverse() * random_point(generator, 0.6);
        worst = std::max(worst, std::abs(kernel(turn * r, turn.transpose() * tensor * turn) - kernel(r, tensor)));
    }
    EXPECT_GT(worst / kernel(Vector3d::Zero(), tensor), 0.1);
}

/// No point of the support lies outside the box, and points of it touch each side.
TEST(SmoothingTensor, TheBoxIsTight) {
    std::mt19937 generator(6);
    const Matrix3d tensor = stretched(1.1, 0.5, 0.3), inverse = tensor.inverse();
    const Vector3d box = support_box(tensor);
    Vector3d reached = Vector3d::Zero();
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 20000; ++trial) {
        const Vector3d y = Vector3d(normal(generator), normal(generator), normal(generator)).normalized();
        reached = reached.cwiseMax((inverse * y).cwiseAbs());
    }
    EXPECT_TRUE((reached.array() <= box.array() * (1 + 1e-14)).all());
    EXPECT_TRUE((reached.array() >= box.array() * 0.999).all());
}

TEST(SmoothingTensor, AxesComeBack) {
    const Matrix3d tensor = stretched(1.1, 0.5, 0.3);
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(tensor);
    EXPECT_NEAR(solver.eigenvalues()(0), 1 / 1.1, 1e-13);
    EXPECT_NEAR(solver.eigenvalues()(2), 1 / 0.3, 1e-13);
    EXPECT_EQ(tensor, tensor.transpose());
}

}  // namespace
}  // namespace cleave::particles
