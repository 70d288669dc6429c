#pragma once

#include "solver/elasticity/equilibrium_operator.hpp"

#include <Eigen/SparseCholesky>

#include <vector>

namespace cleave::elasticity {

/// Second level of the preconditioner: the body as rigid lumps of about `lump_size` particles each (smoothed away by the first level, the
/// block diagonal). z += Z (Z' K Z)^-1 Z' r with the six rigid motions of every lump for the columns of Z: plain aggregation (Vanek, Mandel
/// and Brezina 1996 without their smoothing). It carries what the block diagonal passes on from neighbour to neighbour only.
class CoarseSpace {
public:
    CoarseSpace(const QuadraticEnergy& energy, const GradientStencils& stencils, int lump_size);

    /// correction += Z (Z' K Z)^-1 Z' residual. The same bits for any number of threads.
    void add_correction(const Vectors& residual, Vectors& correction) const;

    int lumps() const { return static_cast<int>(first_.size()) - 1; }
    /// Z' K Z, its lower triangle.
    const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }
    /// The rigid motions of its lump at particle i: column of Z restricted to i, and the number of the lump.
    Eigen::Matrix<double, 3, 6> motion(int i) const;
    int lump_of(int i) const { return lump_[i]; }

private:
    void make_lumps(const Vectors& position, int lump_size);

    const Vectors& position_;
    std::vector<int> member_;  ///< particles, lump after lump
    std::vector<int> first_;   ///< of each lump in member_, one more at the end
    std::vector<int> lump_;    ///< of each particle
    Vectors centre_;
    std::vector<double> size_;
    Eigen::SparseMatrix<double> matrix_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

/// Groups 0 ... count - 1 of points by repeated halving along the longest side until none has more than `most` members: compact, about
/// equal, deterministic.
std::vector<std::vector<int>> halved_groups(const Vectors& position, int most);

}  // namespace cleave::elasticity
