#pragma once

#include "solver/elasticity/strain.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace cleave::elasticity {

/// What a pair reads of its neighbour: place (m), volume (m^3) and displacement (m) in one cache line.
struct alignas(64) PackedParticle {
    double x, y, z, volume;
    double u, v, w, unused;
};

/// A = G G of a support, |G r|^2 = r . A r: the diagonal, twice the rest, and det A.
struct alignas(64) SupportForm {
    double a00, twice01, twice02, a11, twice12, a22, determinant;
};

/// Gradient (`corrected`, Eq. 7), strain (Eq. 1), stress and energy (Eq. 8) of all particles in one pass over all pairs, the weights made
/// anew from the positions: kernels are cheaper to evaluate than 24 bytes a pair are to read.
///
/// With r = x_ji, q^2 = |G_i r|^2 = r . A_i r and w = V_j (1 - q)^2 / q, grad W(x_i - x_j) is (45/pi) det G_i (w / V_j) A_i r (Eq. 4), so
/// that in (grad u)_i = (sum V_j u_ji grad W^T) K_i^-1 the factor and A_i cancel, and of the kernel only q is left:
///
///   (grad u)_i = B S^-1,   B = sum_j w u_ji r^T,   S = sum_j w r r^T (symmetric)
///
/// Four pairs at a time (Highway), then four particles at a time; particles packed into one cache line each, lists filled up to whole
/// vectors with the particle itself, which counts nothing (r = 0). The same to rounding as plain_strain_pass, and the same bits on every
/// processor of the baseline. Particles whose S is too near to singular are left to `corrected` and its pseudo-inverse (operators.hpp).
class StrainPass {
public:
    /// Copies what it needs; lists as found for these particles' tensors (a neighbour outside |G x_ji| < 1 counts nothing).
    /// Throws std::invalid_argument where lists or materials are not one per particle.
    StrainPass(const particles::Particles& particles, const particles::NeighbourLists& neighbours, Solid solid);

    /// `fields` gets the size it needs. Throws std::invalid_argument for a displacement (m) of another size.
    void evaluate(const std::vector<Eigen::Vector3d>& displacement, Fields& fields);

    /// Particles left to the pseudo-inverse by the last evaluation.
    int fallbacks() const { return fallbacks_; }

private:
    void evaluate_four(const std::array<std::size_t, 4>& id, Fields& fields);
    Eigen::Matrix3d gradient_by_pseudo_inverse(int i) const;

    particles::Particles particles_;
    particles::NeighbourLists lists_;  // filled up to multiples of four
    Solid solid_;
    std::vector<PackedParticle> packed_;
    std::vector<SupportForm> forms_;
    int fallbacks_ = 0;
};

/// The same by Eigen, pair by pair as the equations stand: K_i and the sum of Eq. 7, then K_i^-1. The oracle of StrainPass, for particles
/// whose K_i is regular.
void plain_strain_pass(const particles::Particles& particles, const particles::NeighbourLists& neighbours, const Solid& solid,
                       const std::vector<Eigen::Vector3d>& displacement, Fields& fields);

}  // namespace cleave::elasticity
