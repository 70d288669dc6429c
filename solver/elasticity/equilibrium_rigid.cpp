#include "solver/elasticity/equilibrium_rigid.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace cleave::elasticity {

Eigen::Matrix<double, 3, 6> rigid_basis(const Eigen::Vector3d& x) {
    Eigen::Matrix<double, 3, 6> basis;
    basis << 1, 0, 0, 0, x.z(), -x.y(),  //
        0, 1, 0, -x.z(), 0, x.x(),       //
        0, 0, 1, x.y(), -x.x(), 0;
    return basis;
}

RigidMotions::RigidMotions(const Vectors& position, const std::vector<int>& piece, std::vector<double> weight)
    : position_(position), piece_(piece), weight_(std::move(weight)) {
    const int pieces = piece.empty() ? 0 : *std::max_element(piece.begin(), piece.end()) + 1;
    std::vector<double> total(pieces, 0);
    centre_.assign(pieces, Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < position.size(); ++i) centre_[piece[i]] += weight_[i] * position[i], total[piece[i]] += weight_[i];
    for (int p = 0; p < pieces; ++p) centre_[p] /= total[p];
    size_.assign(pieces, 0);
    for (std::size_t i = 0; i < position.size(); ++i) size_[piece[i]] += weight_[i] * (position[i] - centre_[piece[i]]).squaredNorm();
    for (int p = 0; p < pieces; ++p) size_[p] = size_[p] > 0 ? std::sqrt(size_[p] / total[p]) : 1.0;
    std::vector<Gram> gram(pieces, Gram::Zero());
    for (std::size_t i = 0; i < position.size(); ++i) {
        const auto r = basis(static_cast<int>(i));
        gram[piece[i]] += weight_[i] * r.transpose() * r;
    }
    for (const Gram& matrix : gram) {
        // A piece of one or two particles has rotations that do not move them: left out.
        const Eigen::SelfAdjointEigenSolver<Gram> eigen(matrix);
        Motion reciprocal = Motion::Zero();
        for (int k = 0; k < 6; ++k)
            if (eigen.eigenvalues()(k) > 1e-12 * eigen.eigenvalues()(5)) reciprocal(k) = 1 / eigen.eigenvalues()(k);
        inverse_.push_back(eigen.eigenvectors() * reciprocal.asDiagonal() * eigen.eigenvectors().transpose());
    }
}

Eigen::Matrix<double, 3, 6> RigidMotions::basis(int i) const {
    return rigid_basis((position_[i] - centre_[piece_[i]]) / size_[piece_[i]]);
}

Vectors RigidMotions::response(const Vectors& force) const {
    std::vector<Motion> moment(inverse_.size(), Motion::Zero());
    for (std::size_t i = 0; i < force.size(); ++i) moment[piece_[i]] += basis(static_cast<int>(i)).transpose() * force[i];
    for (std::size_t p = 0; p < moment.size(); ++p) moment[p] = inverse_[p] * moment[p];
    Vectors motion(force.size());
    for (std::size_t i = 0; i < force.size(); ++i) motion[i] = basis(static_cast<int>(i)) * moment[piece_[i]];
    return motion;
}

void RigidMotions::balance(Vectors& force) const {
    // Twice: the second round takes out what rounding left of the first.
    for (int round = 0; round < 2; ++round) {
        const Vectors motion = response(force);
        for (std::size_t i = 0; i < force.size(); ++i) force[i] -= weight_[i] * motion[i];
    }
}

void RigidMotions::remove_from(Vectors& displacement) const {
    Vectors momentum(displacement.size());
    for (std::size_t i = 0; i < displacement.size(); ++i) momentum[i] = weight_[i] * displacement[i];
    const Vectors motion = response(momentum);
    for (std::size_t i = 0; i < displacement.size(); ++i) displacement[i] -= motion[i];
}

}  // namespace cleave::elasticity
