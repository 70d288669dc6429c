#pragma once

#include "solver/material/voigt.hpp"

#include <array>

namespace cleave::material {

/// The constants of an orthotropic solid with its axes along x, y, z: moduli in Pa, nu_ij = -strain_j / strain_i under a stress
/// along i, so nu_ij / E_i = nu_ji / E_j. Read back from any compliance too, where it then describes the axes only.
struct EngineeringConstants {
    double E1 = 0, E2 = 0, E3 = 0;
    double G23 = 0, G13 = 0, G12 = 0;
    double nu12 = 0, nu13 = 0, nu23 = 0;
};

// Every maker below throws std::invalid_argument (what() says what was expected) where the result is not positive definite.

/// From Young's modulus (Pa) and Poisson's ratio, -1 < nu < 0.5.
Stiffness isotropic(double young, double poisson);

/// From the three cubic constants (Pa), crystal axes along x, y, z.
Stiffness cubic(double C11, double C12, double C44);

/// Axis 1 (x) is the fibre; the 2-3 plane is isotropic: G23 = E2 / (2 (1 + nu23)).
Stiffness transversely_isotropic(double E1, double E2, double G12, double nu12, double nu23);

Stiffness orthotropic(const EngineeringConstants& constants);

/// From the 21 constants of the upper triangle, row by row: C11, C12, ..., C16, C22, ..., C66 (Pa).
Stiffness from_upper_triangle(const std::array<double, 21>& constants);

/// The same matrix, once symmetry (to 1e-9 of its largest entry) and positive definiteness are checked.
Stiffness checked_stiffness(const Stiffness& stiffness);

/// Kelvin's six eigenvalues (Pa), ascending: of C in an orthonormal basis of strains, so that they do not change with rotation.
Voigt kelvin_moduli(const Stiffness& stiffness);

/// S = C^-1 (1/Pa), symmetric. Throws std::invalid_argument where C is not positive definite.
Stiffness compliance(const Stiffness& stiffness);

/// Young's modulus (Pa) along `direction` (any length > 0): 1/E = n n : S : n n.
double youngs_modulus(const Stiffness& stiffness, const Eigen::Vector3d& direction);

/// Poisson's ratio for a stress along `load`, contraction along `transverse` (orthogonal to it).
double poisson_ratio(const Stiffness& stiffness, const Eigen::Vector3d& load, const Eigen::Vector3d& transverse);

/// Shear modulus (Pa) between two orthogonal directions: 1/G = 4 S_abab.
double shear_modulus(const Stiffness& stiffness, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

EngineeringConstants engineering_constants(const Stiffness& stiffness);

/// The isotropic aggregate (Pa).
struct AggregateModuli {
    double bulk = 0;
    double shear = 0;
    double young() const { return 9 * bulk * shear / (3 * bulk + shear); }
    double poisson() const { return (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)); }
};

/// Uniform strain (Voigt 1928): 9 K = C_iijj, 30 G = 3 C_ijij - C_iijj.
AggregateModuli voigt_moduli(const Stiffness& stiffness);
/// Uniform stress (Reuss 1929): the same invariants of the compliance.
AggregateModuli reuss_moduli(const Stiffness& stiffness);
/// The mean of both (Hill 1952).
AggregateModuli hill_moduli(const Stiffness& stiffness);

/// Young's modulus (Pa) of the isotropic aggregate, Hill's mean of the Voigt and Reuss averages (Hill 1952).
double hill_youngs_modulus(const Stiffness& stiffness);

/// Universal anisotropy index 5 G_V/G_R + K_V/K_R - 6 (Ranganathan and Ostoja-Starzewski 2008): 0 for an isotropic solid.
double universal_anisotropy(const Stiffness& stiffness);

}  // namespace cleave::material
