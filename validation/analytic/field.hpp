#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>

namespace cleave::analytic {

using Point = std::array<double, 3>;                         ///< m
using Voigt = std::array<double, 6>;                         ///< xx, yy, zz, yz, xz, xy; strain with engineering shear
using Gradient = std::array<std::array<double, 3>, 3>;       ///< [a][b] = du_a/dx_b
using Stiffness = std::array<std::array<double, 6>, 6>;      ///< Pa, Voigt

/// An exact solution of linear elasticity, as functions of position.
struct Field {
    std::function<Point(const Point&)> displacement;  ///< m
    std::function<Gradient(const Point&)> gradient;   ///< 1
    std::function<Voigt(const Point&)> stress;        ///< Pa
    std::function<Point(const Point&)> body_force;    ///< N/m^3; empty where there is none
    std::map<std::string, double> scalars;            ///< quantities of the whole body, SI, by name; solutions without fields have only these
    /// Cracks: (quantity, component, place) -> value at the place of the front nearest to a point, SI. Throws std::invalid_argument for a
    /// quantity it does not have.
    std::function<double(const std::string&, const std::string&, const Point&)> at_front;
    std::string source;                               ///< literature, for the report
};

/// Strain (engineering shear) of a displacement gradient.
Voigt strain_of(const Gradient& gradient);

/// sigma_ij = C_ijkl u_k,l by full contraction over the four indices: written with index loops on purpose, so that it shares
/// neither code nor form (6x6 product, engineering shear) with the solver's and the FEM's constitutive laws.
Voigt stress_of(const Stiffness& stiffness, const Gradient& gradient);

/// The component C_ijkl (0-based) of a Voigt stiffness.
double component(const Stiffness& stiffness, int i, int j, int k, int l);

/// Inverse of a symmetric positive definite stiffness (compliance, 1/Pa). Throws std::invalid_argument where it has none.
Stiffness invert(const Stiffness& stiffness);

}  // namespace cleave::analytic
