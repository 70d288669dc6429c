#pragma once

#include "solver/fracture/options.hpp"
#include "solver/material/voigt.hpp"

namespace cleave::fracture {

/// What decides about a crack at one place: the largest principal value and its direction, the crack's normal.
struct Principal {
    double value = 0;                                      ///< Pa (stress) or 1 (strain), the largest principal value
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit; the sign that makes its largest component positive
    double gap = 0;                                        ///< (largest - second) / Frobenius norm: 0 undefined, 1 uniaxial
};

/// Of a symmetric tensor.
Principal largest_principal(const Eigen::Matrix3d& tensor);

/// Rankine's hypothesis: of the stress (Sect. 4.2) or of the strain (Algorithm 1, line 15), both in Voigt order. For anisotropic
/// stiffness the two directions differ: by 30 degrees in T300/5208 pulled 10 degrees off its fibre.
Principal rankine(const material::Voigt& stress, const material::Voigt& strain, Criterion criterion);

}  // namespace cleave::fracture
