#include "solver/elasticity/operators.hpp"

#include <Eigen/SVD>

namespace cleave::elasticity {

namespace {

/// Smallest over largest singular value of the scaled fit below which the nine derivatives count as undetermined.
constexpr double undetermined = 1e-3;

/// First and second derivatives: y_1, y_2, y_3, then y_a y_b, in kernel coordinates y = G x.
Eigen::Matrix<double, 1, 9> quadratic_basis(const Eigen::Vector3d& y) {
    Eigen::Matrix<double, 1, 9> row;
    row << y[0], y[1], y[2], y[0] * y[0], y[1] * y[1], y[2] * y[2], y[1] * y[2], y[0] * y[2], y[0] * y[1];
    return row;
}

/// `corrected` is the linear least-squares fit with weights V_j (1 - q)^2 / q, q = |G x_ji|: that is what -grad W of Eq. 4 leaves
/// after G is taken out. Here its square root.
double root_weight(double volume, double q) { return std::sqrt(volume / q) * (1 - q); }

}  // namespace

Weights quadratic_weights(const particles::Particles& particles, int i, std::span<const int> neighbours,
                          std::span<Eigen::Vector3d> weights) {
    const int count = static_cast<int>(neighbours.size());
    const Eigen::Matrix3d& tensor = particles.tensor[i];
    Eigen::Matrix<double, Eigen::Dynamic, 9> rows(count, 9);
    Eigen::VectorXd root(count);
    for (int n = 0; n < count; ++n) {
        const int j = neighbours[n];
        const Eigen::Vector3d y = tensor * (particles.position[j] - particles.position[i]);
        root[n] = root_weight(particles.volume[j], y.norm());
        rows.row(n) = root[n] * quadratic_basis(y);
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd& values = svd.singularValues();
    const bool determined = count >= 9 && values(8) > undetermined * values(0);
    if (!determined) {
        corrected_weights(particles, i, neighbours, weights);
        return Weights::fallback;
    }
    // du/dy = first three rows of the pseudo-inverse times the weighted differences; du/dx = du/dy G.
    const Eigen::MatrixXd gradient = svd.matrixV().topRows(3) * values.cwiseInverse().asDiagonal() * svd.matrixU().transpose();
    for (int n = 0; n < count; ++n) weights[n] = tensor * gradient.col(n) * root[n];
    return Weights::as_named;
}

}  // namespace cleave::elasticity
