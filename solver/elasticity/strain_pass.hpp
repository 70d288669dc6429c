#pragma once

#include "solver/elasticity/strain.hpp"

#include <cstddef>
#include <memory>

namespace cleave::elasticity {

/// What a pair reads of its neighbour: place (m), volume (m^3) and displacement (m) in one cache line.
struct alignas(64) PackedParticle {
    double x, y, z, volume;
    double u, v, w, unused;
};

/// Gradient (`corrected`, Eq. 7), strain (Eq. 1), stress and energy (Eq. 8) of all particles in one pass over all pairs, the weights made
/// anew from the positions: kernels are cheaper to evaluate than 24 bytes a pair are to read.
///
/// With y = G_i x_ji, q = |y| and w = V_j (1 - q)^2 / q, grad W(x_i - x_j) is (45/pi) det G_i (w / V_j) G_i y (Eq. 4), so that in
/// (grad u)_i = (sum V_j u_ji grad W^T) K_i^-1 the factor and one G_i cancel:
///
///   (grad u)_i = B S^-1 G_i,   B = sum_j w u_ji y^T,   S = sum_j w y y^T (symmetric)
///
/// Four pairs at a time (Highway), particles packed into one cache line each. The same to rounding as plain_strain_pass, and the same bits on every
/// processor of the baseline. Particles whose S is too near to singular are left to `corrected` and its pseudo-inverse (operators.hpp).
class StrainPass {
public:
    /// Copies what it needs; lists as found for these particles' tensors (a neighbour outside |G x_ji| < 1 counts nothing).
    /// Throws std::invalid_argument where lists or materials are not one per particle.
    StrainPass(const particles::Particles& particles, particles::NeighbourLists neighbours, Solid solid);

    /// `fields` gets the size it needs. Throws std::invalid_argument for a displacement (m) of another size.
    void evaluate(const std::vector<Eigen::Vector3d>& displacement, Fields& fields);

    /// Particles left to the pseudo-inverse by the last evaluation.
    int fallbacks() const { return fallbacks_; }

private:
    Eigen::Matrix3d gradient_of(int i);
    Eigen::Matrix3d gradient_by_pseudo_inverse(int i) const;

    particles::Particles particles_;
    particles::NeighbourLists neighbours_;
    Solid solid_;
    std::vector<PackedParticle> packed_;
    int fallbacks_ = 0;
};

/// The same by Eigen, pair by pair as the equations stand: K_i and the sum of Eq. 7, then K_i^-1. The oracle of StrainPass, for particles
/// whose K_i is regular.
void plain_strain_pass(const particles::Particles& particles, const particles::NeighbourLists& neighbours, const Solid& solid,
                       const std::vector<Eigen::Vector3d>& displacement, Fields& fields);

}  // namespace cleave::elasticity
