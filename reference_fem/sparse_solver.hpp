#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace cleave::fem {

/// A symmetric positive definite system: both triangles, compressed rows, columns ascending.
struct SparseSystem {
    std::vector<int> row_start;
    std::vector<int> column;
    std::vector<double> value;
    std::vector<double> right_hand_side;
    /// For each row the two rows of the vertices whose mean it is on the coarse level: itself twice for a vertex; -1 where prescribed.
    std::vector<std::array<int, 2>> parents;

    int size() const { return static_cast<int>(right_hand_side.size()); }
};

struct SparseSolution {
    std::vector<double> values;
    std::string solver;
    int iterations = 0;
    double relative_residual = 0;  ///< |A x - b| / |b|
    double bytes = 0;              ///< matrix and factor
};

/// Supernodal sparse Cholesky (CHOLMOD), METIS ordering, lower triangle only, one step of iterative refinement.
/// BLAS is held to one thread, so that repeats give the same bits. Throws Error if the matrix is singular to working precision:
/// a pivot that is not positive, or a reciprocal condition estimate below 1e-15.
SparseSolution solve_direct(const SparseSystem& system);

/// Conjugate gradients with a symmetric two-level preconditioner: a forward Gauss-Seidel sweep, a Cholesky solve of the Galerkin
/// matrix of the vertices (the linear elements inside the quadratic ones), a backward sweep. The number of iterations hardly grows
/// with the mesh. Stops at |A x - b| <= tolerance |b|; throws Error if that takes more than `iteration_limit` iterations.
SparseSolution solve_iterative(const SparseSystem& system, double tolerance, int iteration_limit);

/// A factorised system, for many right-hand sides. Throws Error if the matrix is singular to working precision.
class DirectFactor {
public:
    explicit DirectFactor(const SparseSystem& system);
    ~DirectFactor();
    DirectFactor(const DirectFactor&) = delete;
    DirectFactor& operator=(const DirectFactor&) = delete;

    std::vector<double> solve(const std::vector<double>& right_hand_side);
    /// The block of the inverse matrix at these rows and columns, row by row.
    std::vector<double> inverse_block(const std::vector<int>& rows);
    double bytes() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace cleave::fem
