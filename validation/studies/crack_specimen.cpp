#include "validation/studies/crack_specimen.hpp"

#include "solver/particles/smoothing_tensor.hpp"
#include "validation/solutions.hpp"

#include <cmath>
#include <numbers>

namespace cleave::validation {

namespace {

/// From the body's axes to those of the half-space below its top, z into the body: half a turn about x.
Eigen::Vector3d turned(const Eigen::Vector3d& v) { return {v.x(), -v.y(), -v.z()}; }

analytic::Point plain(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

material::Stiffness turned(const material::Stiffness& stiffness) {
    return material::rotate_stiffness(stiffness, Eigen::Vector3d(1, -1, -1).asDiagonal().toDenseMatrix());
}

elasticity::Solid solid_of(const std::vector<int>& region, const std::map<int, material::Stiffness>& stiffness) {
    elasticity::Solid solid;
    std::map<int, int> material;
    for (const auto& [tag, matrix] : stiffness) {
        material[tag] = static_cast<int>(solid.stiffness.size());
        solid.stiffness.push_back(matrix);
    }
    for (const int tag : region) solid.material.push_back(material.at(tag));
    return solid;
}

/// Kernels of one radius, for the neighbourhood only.
void set_kernels(particles::Particles& particles, double radius) {
    for (int i = 0; i < particles.size(); ++i) {
        particles.support_radius[i] = radius;
        particles.tensor[i] = particles::isotropic_tensor(radius);
    }
}

}  // namespace

fracture::CrackGenerator CrackSpecimen::generator() const {
    return fracture::CrackGenerator({particles, strain_operator, solid, brittleness, fracture::interface_faces(mesh, solid.material),
                                     fracture::mean_thickness(mesh), fracture::diameter(particles)});
}

CrackSpecimen make_specimen(mesh::TetMesh mesh, const std::map<int, material::Stiffness>& stiffness, double strength, double toughness,
                            const SpecimenOptions& options) {
    CrackSpecimen specimen;
    specimen.mesh = std::move(mesh);
    specimen.particles = particles::from_mesh(specimen.mesh);
    specimen.solid = solid_of(specimen.particles.region, stiffness);
    if (options.wpca) particles::apply_wpca(specimen.particles, *options.wpca);
    const particles::Neighbourhood neighbourhood = particles::build_neighbourhood(specimen.particles);
    specimen.strain_operator = elasticity::make_strain_operator(options.strain_operator, specimen.particles, neighbourhood);
    if (options.neighbourhood > 0) set_kernels(specimen.particles, options.neighbourhood);
    for (const material::Stiffness& one : specimen.solid.stiffness)
        specimen.brittleness.push_back(fracture::uniform_brittleness(strength, toughness, one));
    return specimen;
}

TopContact::TopContact(const material::Stiffness& stiffness, const Eigen::Vector3d& point, const Eigen::Vector3d& force, double radius)
    : point_(point), force_(force), radius_(radius),
      field_(contact::half_space_field(stiffness, {point, -Eigen::Vector3d::UnitZ(), force, radius, 0, Eigen::Vector3d::Zero()})),
      exact_(std::make_shared<analytic::FourierHalfSpace>(plain_stiffness(turned(stiffness)))) {}

fracture::AnalysedPoint TopContact::analysed() const {
    const Eigen::Vector3d tangent(force_.x(), force_.y(), 0);
    return {point_, -Eigen::Vector3d::UnitZ(), tangent, std::numbers::pi * radius_ * radius_};
}

fracture::Displacement TopContact::displacement(const particles::Particles& particles) const {
    return fracture::displacement_from_field(particles, [field = field_](const Eigen::Vector3d& x) { return field.displacement(x); });
}

analytic::Gradient TopContact::exact_gradient(const Eigen::Vector3d& position) const {
    constexpr std::array<double, 3> sign{1, -1, -1};
    constexpr double tolerance = 1e-6;  // far below the operators' errors
    const Eigen::Vector3d below = turned(Eigen::Vector3d(position - point_));
    analytic::Gradient gradient = exact_->response(plain(turned(force_)), radius_, plain(below), tolerance).gradient;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) gradient[a][b] *= sign[a] * sign[b];
    return gradient;
}

const analytic::Gradient& ExactField::at(int particle) {
    const auto found = known_.find(particle);
    if (found != known_.end()) return found->second;
    return known_.emplace(particle, contact_.exact_gradient(particles_.position[particle])).first->second;
}

ExactGroup ExactField::group(const std::vector<int>& members, const material::Stiffness& stiffness) {
    analytic::Gradient mean{};
    double volume = 0;
    for (const int i : members) {
        const analytic::Gradient& gradient = at(i);
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) mean[a][b] += particles_.volume[i] * gradient[a][b];
        volume += particles_.volume[i];
    }
    for (auto& row : mean)
        for (double& entry : row) entry /= volume;
    ExactGroup exact;
    exact.strain = analytic::strain_of(mean);
    exact.stress = analytic::stress_of(plain_stiffness(stiffness), mean);
    exact.principal_stress = analytic::principals(analytic::stress_tensor(exact.stress));
    exact.principal_strain = analytic::principals(analytic::strain_tensor(exact.strain));
    return exact;
}

}  // namespace cleave::validation
