#pragma once

#include "solver/particles/particles.hpp"

#include <span>

namespace cleave::elasticity {

enum class Weights { as_named, fallback };

/// Fills the vectors d_ij (1/m) of one particle, one per neighbour: a strain operator (strain_operator.hpp has the definitions).
/// Says whether a lower operator had to stand in.
using ParticleWeights = Weights (*)(const particles::Particles&, int i, std::span<const int> neighbours,
                                    std::span<Eigen::Vector3d> weights);

Weights paper_weights(const particles::Particles&, int i, std::span<const int> neighbours, std::span<Eigen::Vector3d> weights);
Weights corrected_weights(const particles::Particles&, int i, std::span<const int> neighbours, std::span<Eigen::Vector3d> weights);
Weights quadratic_weights(const particles::Particles&, int i, std::span<const int> neighbours, std::span<Eigen::Vector3d> weights);

}  // namespace cleave::elasticity
