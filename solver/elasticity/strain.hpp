#pragma once

#include "solver/elasticity/strain_operator.hpp"
#include "solver/material/stiffness.hpp"

#include <vector>

namespace cleave::elasticity {

/// Stiffness of each particle: one per material, and the material of each particle.
struct Solid {
    std::vector<material::Stiffness> stiffness;  ///< Pa
    std::vector<int> material;                   ///< index into `stiffness`, one per particle

    const material::Stiffness& of(int particle) const { return stiffness[material[particle]]; }
};

/// One material everywhere.
Solid uniform_solid(const material::Stiffness& stiffness, int particles);

/// Linear strain of a displacement gradient, Eq. 1: eps = (J + J^T)/2 - I with J = I + grad u; Voigt, engineering shear.
/// (The paper swaps the words stress and strain here: eps is the strain.)
material::Voigt strain_of(const Eigen::Matrix3d& displacement_gradient);

/// U_i = V_i (eps . sigma) / 2 in J, Eq. 8; strain with engineering shear, stress without, so the dot product is the work.
double strain_energy(double volume, const material::Voigt& strain, const material::Voigt& stress);

/// Fields of all particles from their displacements.
struct Fields {
    std::vector<Eigen::Matrix3d> gradient;  ///< displacement gradient
    std::vector<material::Voigt> strain;
    std::vector<material::Voigt> stress;    ///< Pa, sigma = C eps
    std::vector<double> energy;             ///< J, per particle

    double total_energy() const;  ///< J, summed by particle id
};

/// Adds one particle of displacement gradient `gradient`, volume (m^3) and stiffness (Pa): strain by Eq. 1, energy by Eq. 8.
void append_linear(Fields& fields, const Eigen::Matrix3d& gradient, double volume, const material::Stiffness& stiffness);

/// The same for a strain already known.
void append_strained(Fields& fields, const Eigen::Matrix3d& gradient, const material::Voigt& strain, double volume,
                     const material::Stiffness& stiffness);

/// Gradient, strain, stress and energy of every particle (Eqs. 7, 1, 8). The plain loop: the oracle of any faster form.
Fields evaluate(const StrainOperator& op, const particles::Particles& particles, const Solid& solid,
                const std::vector<Eigen::Vector3d>& displacement);

}  // namespace cleave::elasticity
