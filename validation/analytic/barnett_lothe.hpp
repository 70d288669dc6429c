#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

using Matrix = std::array<std::array<double, 3>, 3>;

/// (ab)_ik = C_ijkl a_j b_l, in Pa for unit vectors.
Matrix contracted(const Stiffness& stiffness, const Point& a, const Point& b);

/// Axes of a crack front, in the axes of the body: ahead (growth), normal to the crack, along the front; right-handed unit vectors.
using CrackAxes = std::array<Point, 3>;

/// Axes the last of which is a given unit vector, the first two any.
CrackAxes axes_about(const Point& last);

/// C'_ijkl = a_ip a_jq a_kr a_ls C_pqrs: the stiffness as seen in the axes a.
Stiffness in_axes(const Stiffness& stiffness, const CrackAxes& axes);

Matrix inverse(const Matrix& matrix);
Point times(const Matrix& matrix, const Point& vector);
double product(const Point& a, const Point& b);

/// The Barnett-Lothe tensor L (Pa) of a front along `front`, in the axes of the body (Barnett and Lothe 1973, Phys. Norv. 7, 13; Ting 1996,
/// section 7.6): L = (1/2 pi) integral over phi of (mm) - (mn)(nn)^-1(nm), (ab)_ik = C_ijkl a_j b_l, m and n orthogonal unit vectors that
/// turn by phi about the front. No eigenvalues: isotropy is no special case. The trapezium rule of 256 nodes is exact to rounding.
Matrix barnett_lothe(const Stiffness& stiffness, const Point& front);

/// G = k L^-1 k / 2 (J/m^2) with k = (K_II, K_I, K_III) (Pa m^0.5) along the crack's axes (Barnett and Asaro 1972; Ting 1996, Eq. 11.2).
double energy_release(const Stiffness& stiffness, const CrackAxes& axes, const Point& intensities);

/// Stress intensities k = (K_II, K_I, K_III) and mean energy release rate of a penny crack in any material, under a uniform traction t
/// (Pa) on its lips, in the axes of the body: the opening is (4/pi) Lm^-1 t sqrt(a^2 - r^2), Lm the mean of L over the front's directions
/// (Willis 1968, J. Mech. Phys. Solids 16, 419; Ting 1996).
class AnisotropicPenny {
public:
    /// `normal` is the unit normal of the crack's plane; radius in m.
    AnisotropicPenny(const Stiffness& stiffness, const Point& normal, double radius, const Point& traction);
    /// At the place of the front where the crack's axes are these: k = 2 sqrt(a/pi) L Lm^-1 t.
    Point intensities(const CrackAxes& axes) const;
    /// Mean over the front: (2a/pi) t Lm^-1 t, J/m^2.
    double mean_energy_release() const;

private:
    Stiffness stiffness_;
    double radius_;
    Point traction_, opening_;  ///< opening_: Lm^-1 t
};

}  // namespace cleave::analytic
