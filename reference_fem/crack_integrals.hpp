#pragma once

#include "reference_fem/auxiliary_field.hpp"
#include "reference_fem/solution.hpp"

namespace cleave::fem {

/// A solved problem and the growth of its crack: q in m per m of growth, given at vertices and linear in between, tangential to every
/// boundary where it is not zero; zero near a change of material.
struct CrackGrowth {
    const Problem& problem;
    const Solution& solution;
    VectorField growth;
    int lips = 0;  ///< surface of both lips
    /// Where given, of the displacement in place of the solution's (grad[i][j] = du_i/dx_j): what is left is the integrals' own error.
    std::function<Tensor(const Point&)> gradient{};
};

/// Potential energy (J) of a solution: its strain energy less the work of body force, tractions and pressures.
double potential_energy(const Problem& problem, const Solution& solution);

/// m: area that the crack gains per metre of growth, half the change of its lips.
double crack_width(const CrackGrowth& crack);

/// Energy release rate, J/m^2, by the domain integral in the form that is the exact derivative of the discrete potential energy with
/// respect to moved vertices (deLorenzi 1982, Int. J. Fract. 19, 183):
///   G width = int sigma_ij u_i,k q_k,j - W q_k,k dV + int f.u q_k,k + (q.grad f).u dV + int ((div q - n.grad q n) t + q.grad t).u dS,
/// f body force, t tractions; where a stress or a pressure on a surface is given, S n, it is S (div q n - grad q^T n) + (q.grad S) n in the last
/// integrand. Loads are dead fields over space; the displacements prescribed do not move with q. Any material.
double energy_release_by_domain(const CrackGrowth& crack);

/// Stress intensities (K_II, K_I, K_III), means over the growth, by the interaction integral with three auxiliary fields v of stress s
/// (Stern, Becker and Dunham 1976; with Stroh's fields Wang, Stern and Dunham 1980):
///   I width = int sigma_ij v_i,k q_k,j + s_ij u_i,k q_k,j - sigma_ij v_i,j q_k,k + s_ij,j u_i,k q_k dV - int s_ij n_j u_i,k q_k dS + loads,  k = L I,
/// the surface integral over all surfaces where q is not zero; the loads are those of energy_release_by_domain with v in place of u. Not
/// -t_i v_i,k q_k, which is the same by parts: the edges of the mesh cut the curved front short by a strip h^2 / 8R wide, where v_i,k
/// has a share of order h and v of order h^3. `place` is where the growth has its middle: L is taken there.
struct FrontIntensities {
    Intensities k{};
    double energy_release = 0;  ///< k L^-1 k / 2, J/m^2
};
FrontIntensities intensities_by_interaction(const CrackGrowth& crack, const AuxiliaryField& field, const Point& place);

}  // namespace cleave::fem
