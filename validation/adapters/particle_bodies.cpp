#include "validation/adapters/particle_bodies.hpp"

#include "solver/particles/smoothing_tensor.hpp"
#include "validation/adapters/sources.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace cleave::validation {

namespace {

Point plain(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
Voigt plain(const material::Voigt& v) { return {v[0], v[1], v[2], v[3], v[4], v[5]}; }

/// In (-1, 1); the standard's distributions differ between libraries, the engine does not.
double symmetric(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1; }

Eigen::Matrix3d random_axes(std::mt19937_64& engine) {
    Eigen::Vector4d q;
    do
        for (int k = 0; k < 4; ++k) q[k] = symmetric(engine);
    while (q.squaredNorm() > 1 || q.squaredNorm() < 1e-4);  // uniform in the ball, hence on the sphere of unit quaternions
    return Eigen::Quaterniond(q.normalized()).toRotationMatrix();
}

}  // namespace

std::vector<Point> plain(const std::vector<Eigen::Vector3d>& points) {
    std::vector<Point> result;
    for (const Eigen::Vector3d& x : points) result.push_back(plain(x));
    return result;
}

std::vector<Eigen::Vector3d> eigen(const std::vector<Point>& points) {
    std::vector<Eigen::Vector3d> result;
    for (const Point& p : points) result.emplace_back(p[0], p[1], p[2]);
    return result;
}

std::map<int, material::Stiffness> stiffness_by_tag(const Case& of, const geometry::Body& body) {
    std::map<int, material::Stiffness> by_tag;
    for (const auto& [name, tag] : body.regions) by_tag[tag] = material_of(of, name).stiffness;
    return by_tag;
}

elasticity::Solid solid_of(const Case& of, const geometry::Body& body, const std::vector<int>& regions) {
    elasticity::Solid solid;
    std::map<int, int> index;
    for (const auto& [tag, stiffness] : stiffness_by_tag(of, body)) {
        index[tag] = static_cast<int>(solid.stiffness.size());
        solid.stiffness.push_back(stiffness);
    }
    for (const int tag : regions) solid.material.push_back(index.at(tag));
    return solid;
}

void stretch_kernels(particles::Particles& particles, const ParticleSettings& settings) {
    const double aspect = settings.kernel_aspect;
    if (aspect == 1) return;
    std::mt19937_64 engine(static_cast<std::uint64_t>(settings.kernel_seed));
    const Eigen::Vector3d stretch(std::pow(aspect, 2.0 / 3), std::pow(aspect, -1.0 / 3), std::pow(aspect, -1.0 / 3));
    const auto axes = [&]() -> Eigen::Matrix3d {
        if (!settings.kernel_axis) return random_axes(engine);
        const Eigen::Vector3d axis((*settings.kernel_axis)[0], (*settings.kernel_axis)[1], (*settings.kernel_axis)[2]);
        return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), axis).toRotationMatrix();
    };
    for (std::size_t i = 0; i < particles.tensor.size(); ++i)
        particles.tensor[i] = particles::tensor_from_axes(axes(), particles.support_radius[i] * stretch);
}

Samples particle_samples(const particles::Particles& particles, const std::vector<Eigen::Vector3d>& displacement, const elasticity::Fields& fields) {
    Samples samples;
    samples.position = plain(particles.position);
    samples.weight = particles.volume;
    samples.displacement = plain(displacement);
    for (const material::Voigt& strain : fields.strain) samples.strain.push_back(plain(strain));
    for (const material::Voigt& stress : fields.stress) samples.stress.push_back(plain(stress));
    return samples;
}

}  // namespace cleave::validation
