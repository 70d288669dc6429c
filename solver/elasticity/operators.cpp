#include "solver/elasticity/operators.hpp"

#include "solver/particles/kernel.hpp"
#include "solver/particles/neighbourhood.hpp"

#include <Eigen/SVD>

namespace cleave::elasticity {

namespace {

/// Singular values below this fraction of the largest are taken for zero.
constexpr double singular = 1e-6;

/// K^-1 by singular values, without the directions the neighbours do not span.
struct MomentInverse {
    Eigen::Matrix3d inverse;
    Weights quality;
};

MomentInverse invert(const Eigen::Matrix3d& moment) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Vector3d& values = svd.singularValues();
    Eigen::Vector3d reciprocal = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        if (values(k) > singular * values(0)) reciprocal(k) = 1 / values(k);
    const bool full = values(0) > 0 && values(2) > singular * values(0);
    return {svd.matrixV() * reciprocal.asDiagonal() * svd.matrixU().transpose(), full ? Weights::as_named : Weights::fallback};
}

}  // namespace

Weights paper_weights(const particles::Particles& particles, int i, std::span<const int> neighbours,
                      std::span<Eigen::Vector3d> weights) {
    for (std::size_t n = 0; n < neighbours.size(); ++n) {
        const int j = neighbours[n];
        const Eigen::Vector3d x_ij = particles.position[i] - particles.position[j];
        weights[n] = particles.volume[j] * particles::kernel_gradient(x_ij, particles.tensor[i]);
    }
    return Weights::as_named;
}

Weights corrected_weights(const particles::Particles& particles, int i, std::span<const int> neighbours,
                          std::span<Eigen::Vector3d> weights) {
    paper_weights(particles, i, neighbours, weights);
    // (sum_j V_j u_ji grad W^T) K^-1 = sum_j u_ji (K^-T V_j grad W)^T; K is not symmetric, so the transpose matters.
    const MomentInverse moment = invert(particles::moment_matrix(particles, i, neighbours));
    for (Eigen::Vector3d& weight : weights) weight = moment.inverse.transpose() * weight;
    return moment.quality;
}

}  // namespace cleave::elasticity
