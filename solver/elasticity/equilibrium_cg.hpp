#pragma once

#include "solver/elasticity/equilibrium_parallel.hpp"

#include <functional>

namespace cleave::elasticity {

/// K, its preconditioner, and (for a singular K) the projection off its kernel.
struct LinearSystem {
    std::function<void(const Vectors&, Vectors&)> apply;
    std::function<void(const Vectors&, Vectors&)> precondition;
    std::function<void(Vectors&)> project{};  ///< may be empty
};

struct CgResult {
    int iterations = 0;
    double residual = 0;  ///< |b - K x| / |b|, evaluated anew
};

/// Preconditioned conjugate gradients from the given x; stops at |r| <= tolerance |b|. Deterministic for any number of threads.
CgResult conjugate_gradients(const LinearSystem& system, const Vectors& b, Vectors& x, double tolerance, int max_iterations);

}  // namespace cleave::elasticity
