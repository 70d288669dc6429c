#pragma once

#include "solver/elasticity/conforming_body.hpp"
#include "solver/elasticity/equilibrium_parallel.hpp"

#include <vector>

namespace cleave::elasticity {

/// A boundary face where components of the displacement are prescribed.
struct PrescribedFace {
    int face;
    Eigen::Vector3d mask;   ///< 1 for a prescribed component, else 0
    Eigen::Vector3d value;  ///< m, zero where the mask is
};

/// Nitsche's penalty over the least one that keeps the energy positive, see QuadraticEnergy.
inline constexpr double nitsche_margin = 2;

/// The energy of a body as a function of its particles' displacements u, with everything that is quadratic in u:
///
///   E(u) = sum_i V_i eps_i:C:eps_i / 2                                                                       strain
///        + sum over links of alpha E (V_i + V_j) / (8 |x_ji|^2) |u_ji - grad u_i d_i - grad u_j d_j|^2 / 2    link penalty
///        + sum over prescribed faces of [ -(sigma_i A n) . P u_f + P u_f . N P u_f / 2 ]                     Nitsche
///
/// alpha the link penalty, E the Hill-average Young's modulus (mean of the two sides); d_i = d_j = x_ji / 2, but d_i = x_f - x_i and
/// d_j = x_j - x_f across an interface, where the gradient jumps (physics.md 4). P keeps the prescribed components. With
/// Q = A^2 n.C.n the acoustic tensor of the face, (sigma_i A n).w <= sqrt(eps_i:C:eps_i) sqrt(w.Q w), so that N = margin m Q / V_i
/// leaves the sum positive for margin > 1, m the number of prescribed faces of the tet: no constant of the mesh is needed.
/// The printed link energy of physics.md is 1/2 alpha E (V_i+V_j)/(8|x|^2)|r|^2, which is what stands above.
struct QuadraticEnergy {
    const ConformingBody* body;
    std::vector<double> link;                ///< N/m per face, 0 at the boundary
    std::vector<Eigen::Vector3d> link_inside, link_outside;  ///< d_i and d_j, m
    std::vector<PrescribedFace> prescribed;  ///< by face
    std::vector<int> prescription_of;        ///< per face: index into `prescribed`, -1
    std::vector<Eigen::Matrix3d> nitsche;    ///< P N P of every prescribed face, N/m
};

/// `body` must outlive the result.
QuadraticEnergy make_energy(const ConformingBody& body, double link_penalty, std::vector<PrescribedFace> prescribed = {});

/// K u, K the second derivative of E: symmetric, positive semidefinite with the rigid motions for its kernel (nothing prescribed) or
/// definite. Matrix-free: traces, gradients, stresses, face forces, and the transposed traces; the same bits for any number of threads.
class StiffnessOperator {
public:
    explicit StiffnessOperator(const QuadraticEnergy& energy) : energy_(energy) {}

    /// force = K displacement, N.
    void apply(const Vectors& displacement, Vectors& force);

private:
    void particle_stresses(const Vectors& displacement);
    void face_forces();

    const QuadraticEnergy& energy_;
    Vectors trace_, link_force_, face_force_, self_force_;
    std::vector<Eigen::Matrix3d> gradient_, weighted_stress_;
};

/// The 3x3 blocks on the diagonal of K, N/m; `stencils` are those of the energy's body.
std::vector<Eigen::Matrix3d> diagonal_blocks(const QuadraticEnergy& energy, const GradientStencils& stencils);

/// Energy of the link penalty, J.
double link_energy(const QuadraticEnergy& energy, const Vectors& displacement);

/// r of a link: zero where the displacement is linear (on either side of an interface).
Eigen::Vector3d link_mismatch(const QuadraticEnergy& energy, int face, const Vectors& displacement,
                              const std::vector<Eigen::Matrix3d>& gradient);

/// C_abcd a_b b_d: (a.C.b) of two vectors, the force on a face of area vector a per displacement gradient v (x) b.
Eigen::Matrix3d contract(const material::Stiffness& stiffness, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace cleave::elasticity
