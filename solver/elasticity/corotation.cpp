#include "solver/elasticity/corotation.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace cleave::elasticity {

namespace {

/// sum_j (M^T (x_j - x_i) - (x0_j - x0_i)) d_ij^T
Eigen::Matrix3d turned_back_gradient(const StrainOperator& op, int i, const Eigen::Matrix3d& rotation,
                                     const std::vector<Eigen::Vector3d>& rest, const std::vector<Eigen::Vector3d>& position) {
    const auto neighbours = op.neighbours.of(i);
    const auto weights = op.weights_of(i);
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    for (std::size_t n = 0; n < neighbours.size(); ++n) {
        const int j = neighbours[n];
        const Eigen::Vector3d u_ji = rotation.transpose() * (position[j] - position[i]) - (rest[j] - rest[i]);
        gradient += u_ji * weights[n].transpose();
    }
    return gradient;
}

}  // namespace

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& deformation) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(deformation, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    return svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

std::vector<Eigen::Matrix3d> rotations(const StrainOperator& op, const std::vector<Eigen::Vector3d>& position) {
    std::vector<Eigen::Matrix3d> result;
    for (const Eigen::Matrix3d& deformation : displacement_gradients(op, position)) result.push_back(nearest_rotation(deformation));
    return result;
}

Corotation corotate(const StrainOperator& op, const StrainOperator& rotation_operator, const particles::Particles& at_rest,
                    const Solid& solid, const std::vector<Eigen::Vector3d>& position) {
    Corotation state{rotations(rotation_operator, position), {}};
    for (int i = 0; i < at_rest.size(); ++i) {
        const Eigen::Matrix3d gradient = turned_back_gradient(op, i, state.rotation[i], at_rest.position, position);
        append_linear(state.fields, gradient, at_rest.volume[i], solid.of(i));
    }
    return state;
}

std::vector<Eigen::Matrix3d> corotated_pair_stress(const Corotation& state) {
    std::vector<Eigen::Matrix3d> result = linear_pair_stress(state.fields);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = state.rotation[i] * result[i];
    return result;
}

}  // namespace cleave::elasticity
