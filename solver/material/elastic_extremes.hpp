#pragma once

#include "solver/material/voigt.hpp"

#include <array>

namespace cleave::material {

/// Where a modulus takes an extreme value: along `first` (the stress of Young's modulus and Poisson's ratio, one side of the shear), and
/// `second` across it (zero for Young's modulus). Unit vectors.
struct Extreme {
    double value = 0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero(), second = Eigen::Vector3d::Zero();
};

struct Extremes {
    Extreme smallest, largest;
};

// Found by a search of all directions in steps of 4 degrees whose best places are then refined until the direction moves by less than 1e-8 rad:
// the value is right to 1e-12, unless two extremes lie closer together than the steps. Throw std::invalid_argument where C is not
// positive definite.

/// Young's modulus (Pa) over all directions.
Extremes youngs_modulus_extremes(const Stiffness& stiffness);
/// Shear modulus (Pa) over all pairs of orthogonal directions.
Extremes shear_modulus_extremes(const Stiffness& stiffness);
/// Poisson's ratio over all pairs of a stress and a direction across it.
Extremes poisson_ratio_extremes(const Stiffness& stiffness);

/// Phase speeds (m/s) of plane waves along `direction` (any length > 0), ascending: roots of the eigenvalues of Christoffel's tensor
/// C_ijkl n_j n_l / density (Auld 1973, Sect. 7). `density` in kg/m^3, above zero.
Eigen::Vector3d wave_speeds(const Stiffness& stiffness, double density, const Eigen::Vector3d& direction);

}  // namespace cleave::material
