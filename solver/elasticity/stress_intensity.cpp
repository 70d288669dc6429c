#include "solver/elasticity/stress_intensity.hpp"

#include "solver/elasticity/crack_tip_field.hpp"

#include <Eigen/LU>

namespace cleave::elasticity {

namespace {

/// The near-tip fields in the axes of the body.
class TipInBody {
public:
    TipInBody(const material::Stiffness& stiffness, const StraightFront& front)
        : front_(front), stiffness_(stiffness), field_(material::rotate_stiffness(stiffness, front.axes.transpose())) {}

    std::array<Eigen::Matrix3d, 3> gradients(const Eigen::Vector3d& x) const {
        const Eigen::Vector3d local = front_.axes.transpose() * (x - front_.origin);
        std::array<Eigen::Matrix3d, 3> gradient = field_.gradients(local[0], local[1]);
        for (Eigen::Matrix3d& g : gradient) g = front_.axes * g * front_.axes.transpose();
        return gradient;
    }
    Eigen::Matrix3d stress(const Eigen::Matrix3d& gradient) const {
        return material::stress_from_voigt(stiffness_ * material::strain_to_voigt(0.5 * (gradient + gradient.transpose())));
    }
    const Eigen::Matrix3d& compliance() const { return field_.compliance(); }

private:
    StraightFront front_;
    material::Stiffness stiffness_;
    CrackTipField field_;
};

double product(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) { return a.cwiseProduct(b).sum(); }

/// Loads on the boundary faces that grow: t.(grad v q) A, by mode.
Eigen::Vector3d surface_terms(const EquilibriumProblem& problem, const EquilibriumSolution& solution, const TipInBody& tip, const VectorField& growth) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const BoundaryTrace& face : solution.boundary) {
        const Eigen::Vector3d q = growth(face.position);
        if (q.isZero(0)) continue;
        Eigen::Vector3d load = Eigen::Vector3d::Zero();
        for (const Traction& t : problem.tractions)
            if (t.surface == face.surface) load += t.value(face.position, face.normal);
        for (const Pressure& p : problem.pressures)
            if (p.surface == face.surface) load -= p.value * face.normal;
        if (load.isZero(0)) continue;
        // A little inside: on the lips the side counts.
        const auto gradient = tip.gradients(face.position - 1e-6 * std::sqrt(face.area) * face.normal);
        for (int mode = 0; mode < 3; ++mode) sum[mode] += face.area * load.dot(gradient[mode] * q);
    }
    return sum;
}

}  // namespace

StressIntensities stress_intensities(const EquilibriumProblem& problem, const EquilibriumSolution& solution, const StraightFront& front,
                                     const CrackExtension& extension) {
    const particles::Particles& particles = solution.body->particles;
    const TipInBody tip(solution.body->solid.of(0), front);
    std::vector<Eigen::Vector3d> growth;
    for (const Eigen::Vector3d& x : problem.mesh.vertices) growth.push_back(extension.growth(x));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < particles.size(); ++i) {
        const Eigen::Matrix3d slope = growth_gradient(problem.mesh, i, growth);
        if (slope.isZero(0) && !problem.body_force) continue;
        const Eigen::Vector3d& x = particles.position[i];
        const Eigen::Matrix3d stress = material::stress_from_voigt(solution.fields.stress[i]);
        const auto v = tip.gradients(x);
        for (int mode = 0; mode < 3; ++mode) {
            double density = product(stress, v[mode] * slope) + product(tip.stress(v[mode]), solution.fields.gradient[i] * slope) -
                             product(stress, v[mode]) * slope.trace();
            if (problem.body_force) density -= problem.body_force(x).dot(v[mode] * extension.growth(x));
            sum[mode] += particles.volume[i] * density;
        }
    }
    sum -= surface_terms(problem, solution, tip, extension.growth);
    StressIntensities result;
    result.k = tip.compliance().inverse() * sum / crack_width(problem.mesh, extension);
    result.energy_release = 0.5 * result.k.dot(tip.compliance() * result.k);
    return result;
}

}  // namespace cleave::elasticity
