#pragma once

#include <Eigen/Core>

#include <span>

namespace cleave::contact {

/// An isotropic half-space z >= 0, loaded at the origin by `force` (N, per axis; z into the body), spread like Hertz's pressure over a
/// circle of `radius` (m), or a point force where that is zero. Closed forms of Boussinesq, Cerruti and Hertz in one: Love's potential
/// with the derivatives of the unit source moved into the complex (isotropic_half_space.cpp).
struct IsotropicContact {
    double shear_modulus;  ///< Pa
    double poisson_ratio;
    double radius;
    Eigen::Vector3d force;
};

/// u (m) at `position` (m, z >= 0).
Eigen::Vector3d isotropic_displacement(const IsotropicContact& contact, const Eigen::Vector3d& position);

/// The same at many places, four at a time where they are far: the same bits.
void isotropic_displacements(const IsotropicContact& contact, std::span<const Eigen::Vector3d> positions, std::span<Eigen::Vector3d> displacement);

/// du_a / dx_b.
Eigen::Matrix3d isotropic_gradient(const IsotropicContact& contact, const Eigen::Vector3d& position);

}  // namespace cleave::contact
