#pragma once

#include <Eigen/Core>

namespace cleave::material {

/// Strain or stress in Voigt order xx, yy, zz, yz, xz, xy. Strain carries the ENGINEERING shear (gamma = 2 eps), stress does not.
using Voigt = Eigen::Matrix<double, 6, 1>;

/// Stiffness C (Pa) or compliance S (1/Pa): stress = C strain, both in the Voigt form above. Symmetric.
using Stiffness = Eigen::Matrix<double, 6, 6>;

Voigt strain_to_voigt(const Eigen::Matrix3d& strain);
Eigen::Matrix3d strain_from_voigt(const Voigt& strain);
Voigt stress_to_voigt(const Eigen::Matrix3d& stress);
Eigen::Matrix3d stress_from_voigt(const Voigt& stress);

/// Stiffness of the material turned by `rotation` (its axis n then lies along rotation n): K C K^T with Bond's matrix K, which
/// turns a Voigt stress (Auld 1973, Acoustic Fields and Waves in Solids, Eq. 3.34). `rotation` is orthogonal.
Stiffness rotate_stiffness(const Stiffness& stiffness, const Eigen::Matrix3d& rotation);

/// The same by the definition C'_ijkl = R_ia R_jb R_kc R_ld C_abcd, without Bond's matrix: slower, the oracle of the form above.
Stiffness rotate_stiffness_by_components(const Stiffness& stiffness, const Eigen::Matrix3d& rotation);

}  // namespace cleave::material
