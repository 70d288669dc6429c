#pragma once

#include "solver/elasticity/energy_release.hpp"

namespace cleave::elasticity {

/// A straight crack front: a place on it and its axes (columns: along the growth, normal to the crack, along the front).
struct StraightFront {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

struct StressIntensities {
    Eigen::Vector3d k = Eigen::Vector3d::Zero();  ///< K_II, K_I, K_III, Pa m^0.5
    double energy_release = 0;                    ///< k L^-1 k / 2, J/m^2
};

/// Stress intensities of the particle fields at a straight front inside one material, by the interaction integral (Stern, Becker and
/// Dunham 1976) with the fields v, stress s, of CrackTipField, summed over the particles:
///   I width = sum_i V_i (sigma.(grad v grad q) + s.(grad u grad q) - sigma.grad v div q - f.(grad v q)) - sum_faces A t.(grad v q),  k = L I,
/// q the extension's growth, f body force, t the loads on surfaces. Growth must leave the sides that the front ends on in their planes.
/// Throws std::invalid_argument: growth that adds no crack area.
StressIntensities stress_intensities(const EquilibriumProblem& problem, const EquilibriumSolution& solution, const StraightFront& front,
                                     const CrackExtension& extension);

}  // namespace cleave::elasticity
