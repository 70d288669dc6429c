#pragma once

#include "solver/material/voigt.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace cleave::elasticity {

/// Leading fields of a straight crack front in any material (generalised plane strain), in axes of the front: 1 along the growth, 2 normal
/// to the crack, 3 along the front. No eigenvalues, so that isotropy is no special case: with Stroh's real matrix N(w) of the directions
/// turned by w (Barnett and Lothe 1973; Ting 1996, section 7.1), displacement u and stress function phi are
///   (u, phi) = sqrt(2 r / pi) E(t) (M, 1) k,   E(t) = exp(1/2 int_0^t N(w) dw),
/// since N(w) has the same eigenvectors for every w and the integral of an eigenvalue p(w) is log(cos t + p sin t). The lips are free
/// where M = -E21(pi)^-1 E22(pi); then L^-1 = E11(pi) M + E12(pi). k = (K_II, K_I, K_III).
class CrackTipField {
public:
    /// `stiffness` in axes of the front, Pa.
    explicit CrackTipField(const material::Stiffness& stiffness);

    /// du/dx of unit K_II, K_I, K_III at the place (x1, x2) (m) from the front, 1 / (Pa m^0.5).
    std::array<Eigen::Matrix3d, 3> gradients(double x1, double x2) const;

    /// L^-1 (1/Pa): G = k L^-1 k / 2.
    const Eigen::Matrix3d& compliance() const { return compliance_; }

private:
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    using Shape = Eigen::Matrix<double, 6, 3>;  // E(t) (M, 1), in units of the stiffness
    Matrix6 fundamental(double angle) const;
    Shape shape(double angle) const;

    material::Stiffness scaled_;  // over its (4, 4) entry
    double scale_;
    std::vector<Shape> shapes_;   // at equal angles from -pi to pi
    Eigen::Matrix3d compliance_;
};

}  // namespace cleave::elasticity
