#include "solver/elasticity/strain_pass.hpp"
#include "solver/particles/kernel.hpp"

#include <Eigen/LU>

namespace cleave::elasticity {

void plain_strain_pass(const particles::Particles& particles, const particles::NeighbourLists& neighbours, const Solid& solid,
                       const std::vector<Eigen::Vector3d>& displacement, Fields& fields) {
    fields.gradient.clear(), fields.strain.clear(), fields.stress.clear(), fields.energy.clear();
    for (int i = 0; i < particles.size(); ++i) {
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero(), moment = Eigen::Matrix3d::Zero();
        for (const int j : neighbours.of(i)) {
            const Eigen::Vector3d x_ji = particles.position[j] - particles.position[i];
            const Eigen::Vector3d weight = particles.volume[j] * particles::kernel_gradient(-x_ji, particles.tensor[i]);
            sum += (displacement[j] - displacement[i]) * weight.transpose();
            moment += x_ji * weight.transpose();
        }
        append_linear(fields, sum * moment.inverse(), particles.volume[i], solid.of(i));
    }
}

}  // namespace cleave::elasticity
