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

void append_strained(Fields& fields, const Eigen::Matrix3d& gradient, const material::Voigt& strain, double volume,
                     const material::Stiffness& stiffness) {
    const material::Voigt stress = stiffness * strain;
    fields.gradient.push_back(gradient);
    fields.strain.push_back(strain);
    fields.stress.push_back(stress);
    fields.energy.push_back(strain_energy(volume, strain, stress));
}

void append_linear(Fields& fields, const Eigen::Matrix3d& gradient, double volume, const material::Stiffness& stiffness) {
    append_strained(fields, gradient, strain_of(gradient), volume, stiffness);
}

Fields evaluate(const StrainOperator& op, const particles::Particles& particles, const Solid& solid,
                const std::vector<Eigen::Vector3d>& displacement) {
    Fields fields;
    for (int i = 0; i < particles.size(); ++i)
        append_linear(fields, displacement_gradient(op, i, displacement), particles.volume[i], solid.of(i));
    return fields;
}

}  // namespace cleave::elasticity
