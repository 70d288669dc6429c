#pragma once

#include "solver/elasticity/strain.hpp"
#include "validation/case.hpp"
#include "validation/samples.hpp"

#include <map>
#include <vector>

namespace cleave::validation {

std::vector<Point> plain(const std::vector<Eigen::Vector3d>& points);
std::vector<Eigen::Vector3d> eigen(const std::vector<Point>& points);

/// Stiffness of each region of the body, by tag. Throws InputError where the case gives none.
std::map<int, material::Stiffness> stiffness_by_tag(const Case& of, const geometry::Body& body);

/// One material per region of the body.
elasticity::Solid solid_of(const Case& of, const geometry::Body& body, const std::vector<int>& regions);

/// Stretches every kernel to an ellipsoid of half axes h (aspect^(2/3), aspect^(-1/3), aspect^(-1/3)), determinant kept, long axis
/// along the one given or in a random direction of its own per particle (seeded, the same on every machine).
void stretch_kernels(particles::Particles& particles, const ParticleSettings& settings);

/// Particle fields as samples, weighted by volume.
Samples particle_samples(const particles::Particles& particles, const std::vector<Eigen::Vector3d>& displacement, const elasticity::Fields& fields);

}  // namespace cleave::validation
