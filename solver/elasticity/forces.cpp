#include "solver/elasticity/forces.hpp"

namespace cleave::elasticity {

std::vector<Eigen::Vector3d> pair_forces(const StrainOperator& op, const particles::Particles& particles,
                                         const std::vector<Eigen::Matrix3d>& pair_stress) {
    std::vector<Eigen::Vector3d> force(particles.size(), Eigen::Vector3d::Zero());
    for (int i = 0; i < particles.size(); ++i) {
        const auto neighbours = op.neighbours.of(i);
        const auto weights = op.weights_of(i);
        const Eigen::Matrix3d scaled = particles.volume[i] * pair_stress[i];
        for (std::size_t n = 0; n < neighbours.size(); ++n) {
            const Eigen::Vector3d on_neighbour = -scaled * weights[n];
            force[neighbours[n]] += on_neighbour;
            force[i] -= on_neighbour;
        }
    }
    return force;
}

std::vector<Eigen::Matrix3d> linear_pair_stress(const Fields& fields) {
    std::vector<Eigen::Matrix3d> result;
    for (const material::Voigt& stress : fields.stress) result.push_back(material::stress_from_voigt(stress));
    return result;
}

std::vector<Eigen::Matrix3d> paper_pair_stress(const Fields& fields) {
    std::vector<Eigen::Matrix3d> result = linear_pair_stress(fields);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = (Eigen::Matrix3d::Identity() + fields.gradient[i].transpose()) * result[i];
    return result;
}

Fields evaluate_green(const StrainOperator& op, const particles::Particles& particles, const Solid& solid,
                      const std::vector<Eigen::Vector3d>& displacement) {
    Fields fields;
    for (int i = 0; i < particles.size(); ++i) {
        const Eigen::Matrix3d g = displacement_gradient(op, i, displacement);
        // (J^T J - I)/2 = (g + g^T + g^T g)/2, without the cancellation of the ones.
        const material::Voigt strain = material::strain_to_voigt(0.5 * (g + g.transpose() + g.transpose() * g));
        append_strained(fields, g, strain, particles.volume[i], solid.of(i));
    }
    return fields;
}

std::vector<Eigen::Matrix3d> green_pair_stress(const Fields& green) {
    std::vector<Eigen::Matrix3d> result = linear_pair_stress(green);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = (Eigen::Matrix3d::Identity() + green.gradient[i]) * result[i];
    return result;
}

}  // namespace cleave::elasticity
