#include "solver/elasticity/strain.hpp"

namespace cleave::elasticity {

Solid uniform_solid(const material::Stiffness& stiffness, int particles) { return {{stiffness}, std::vector<int>(particles, 0)}; }

material::Voigt strain_of(const Eigen::Matrix3d& displacement_gradient) {
    // (J + J^T)/2 - I without the cancellation of adding and subtracting I.
    return material::strain_to_voigt(0.5 * (displacement_gradient + displacement_gradient.transpose()));
}

double strain_energy(double volume, const material::Voigt& strain, const material::Voigt& stress) {
    return 0.5 * volume * strain.dot(stress);
}

double Fields::total_energy() const {
    double sum = 0;
    for (const double value : energy) sum += value;
    return sum;
}

Fields evaluate(const StrainOperator& op, const particles::Particles& particles, const Solid& solid,
                const std::vector<Eigen::Vector3d>& displacement) {
    Fields fields;
    fields.gradient = displacement_gradients(op, displacement);
    for (int i = 0; i < particles.size(); ++i) {
        fields.strain.push_back(strain_of(fields.gradient[i]));
        fields.stress.push_back(solid.of(i) * fields.strain[i]);
        fields.energy.push_back(strain_energy(particles.volume[i], fields.strain[i], fields.stress[i]));
    }
    return fields;
}

}  // namespace cleave::elasticity
