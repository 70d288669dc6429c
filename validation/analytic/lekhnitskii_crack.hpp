#pragma once

#include "validation/analytic/barnett_lothe.hpp"

#include <complex>

namespace cleave::analytic {

/// Generalised plane strain (displacement independent of x3, eps_33 = 0) in any material, by Lekhnitskii's stress functions (Lekhnitskii
/// 1963, Theory of Elasticity of an Anisotropic Body; Ting 1996, chapter 5), in axes of the crack: with reduced compliances
/// s'_ij = s_ij - s_i3 s_j3 / s_33, the roots mu of l2 l4 - l3^2 = 0 with Im mu > 0, where
///   l2 = s'55 mu^2 - 2 s'45 mu + s'44,
///   l3 = s'15 mu^3 - (s'14 + s'56) mu^2 + (s'25 + s'46) mu - s'24,
///   l4 = s'11 mu^4 - 2 s'16 mu^3 + (2 s'12 + s'66) mu^2 - 2 s'26 mu + s'22,
/// each give displacement a f(z) and stress function b f(z) of z = x1 + mu x2, sigma_i1 = -phi_i,2, sigma_i2 = phi_i,1.
/// Equal roots (isotropy in the plane) are parted by a change of s'66 by 1e-6.
struct PlaneModes {
    std::array<std::complex<double>, 3> mu{};
    std::array<std::array<std::complex<double>, 3>, 3> a{}, b{};  ///< [component][mode]
    std::array<std::array<std::complex<double>, 3>, 3> b_inverse{};
};
PlaneModes plane_modes(const Stiffness& stiffness_in_crack_axes);

/// A straight crack of half length a (m) in an infinite plane, along axes[0], normal axes[1], endless along axes[2], centre at the origin,
/// free of traction; any material, any remote traction t = (sigma_12, sigma_22, sigma_32) (Pa, along the crack's axes) on its plane.
/// The remote stress is the one that the far traction and `along` (sigma_11, sigma_13) make with eps_33 = 0.
///   u = E x + Re A <sqrt(z^2 - a^2) - z> B^-1 t (Stroh 1958; Ting 1996, section 11.3), k = (K_II, K_I, K_III) = t sqrt(pi a) at both tips
/// (with the axes of the tip ahead; at the other one K_II and K_III change sign with the axes turned by 180 degrees about the normal).
Field straight_crack(const Stiffness& stiffness, const CrackAxes& axes, double half_length, const Point& traction,
                     const std::array<double, 2>& along);

/// Hoop stress at the tip times sqrt(2 pi r), Pa m^0.5, at the angle theta from the crack's direction, for K_I and K_II in a plane of
/// elastic symmetry (Sih, Paris and Irwin 1965, Int. J. Fract. Mech. 1, 189), h_i^2 = cos theta + mu_i sin theta:
///   K_I Re (mu1 h2^3 - mu2 h1^3)/(mu1 - mu2) + K_II Re (h2^3 - h1^3)/(mu1 - mu2).
/// `stiffness` in crack axes. Throws std::invalid_argument where x3 = 0 is no plane of symmetry.
class AnisotropicHoop {
public:
    explicit AnisotropicHoop(const Stiffness& stiffness_in_crack_axes);
    double operator()(double angle, double K_I, double K_II) const;

private:
    std::complex<double> mu1_, mu2_;
};

}  // namespace cleave::analytic
