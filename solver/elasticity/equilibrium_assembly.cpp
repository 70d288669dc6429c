#include "solver/elasticity/equilibrium_assembly.hpp"

#include <Eigen/CholmodSupport>

#include <stdexcept>

namespace cleave::elasticity {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

template <class Block>
void add_block(Triplets& triplets, int row, int column, const Block& block) {
    for (int a = 0; a < block.rows(); ++a)
        for (int b = 0; b < block.cols(); ++b)
            if (block(a, b) != 0) triplets.emplace_back(row + a, column + b, block(a, b));
}

Sparse to_matrix(Eigen::Index rows, Eigen::Index columns, const Triplets& triplets) {
    Sparse matrix(rows, columns);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

/// All gradients from all displacements, 9N x 3N: row 9 i + 3 a + b holds du_a / dx_b.
Sparse gradient_matrix(const ConformingBody& body) {
    const GradientStencils stencils = gradient_stencils(body);
    Triplets triplets;
    for (int i = 0; i < body.particles.size(); ++i)
        for (std::size_t n = stencils.offset[i]; n < stencils.offset[i + 1]; ++n)
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b) triplets.emplace_back(9 * i + 3 * a + b, 3 * stencils.index[n] + a, stencils.weight[n][b]);
    return to_matrix(9 * body.particles.size(), 3 * body.particles.size(), triplets);
}

/// Stiffness as a map of gradients to stresses, both in nine components, times the volume.
Sparse stress_matrix(const ConformingBody& body) {
    Triplets triplets;
    for (int i = 0; i < body.particles.size(); ++i)
        for (int n = 0; n < 9; ++n) {
            Eigen::Matrix3d unit = Eigen::Matrix3d::Zero();
            unit(n / 3, n % 3) = body.particles.volume[i];
            const Eigen::Matrix3d stress = material::stress_from_voigt(body.solid.of(i) * strain_of(unit));
            for (int m = 0; m < 9; ++m) triplets.emplace_back(9 * i + m, 9 * i + n, stress(m / 3, m % 3));
        }
    return to_matrix(9 * body.particles.size(), 9 * body.particles.size(), triplets);
}

/// The mismatch of every link, times the square root of its size, 3F x 3N.
Sparse link_matrix(const QuadraticEnergy& energy, const Sparse& gradients) {
    const ConformingBody& body = *energy.body;
    Triplets jumps, slopes;
    for (int f = 0; f < body.faces.size(); ++f) {
        if (!(energy.link[f] > 0)) continue;
        const Face& face = body.faces.faces[f];
        const double size = std::sqrt(energy.link[f]);
        for (int a = 0; a < 3; ++a) {
            jumps.emplace_back(3 * f + a, 3 * face.outside + a, size);
            jumps.emplace_back(3 * f + a, 3 * face.inside + a, -size);
            for (int b = 0; b < 3; ++b) {
                slopes.emplace_back(3 * f + a, 9 * face.inside + 3 * a + b, size * energy.link_inside[f][b]);
                slopes.emplace_back(3 * f + a, 9 * face.outside + 3 * a + b, size * energy.link_outside[f][b]);
            }
        }
    }
    const int rows = 3 * body.faces.size(), particles = body.particles.size();
    return to_matrix(rows, 3 * particles, jumps) - Sparse(to_matrix(rows, 9 * particles, slopes) * gradients);
}

struct PrescribedRows {
    Sparse trace;     ///< P u_f from displacements
    Sparse reaction;  ///< A_f n_f contracted with nine stress components times the volume of the tet
    Sparse penalty;
};

PrescribedRows prescribed_rows(const QuadraticEnergy& energy) {
    const ConformingBody& body = *energy.body;
    Triplets trace, reaction, penalty;
    for (std::size_t n = 0; n < energy.prescribed.size(); ++n) {
        const PrescribedFace& at = energy.prescribed[n];
        const Face& face = body.faces.faces[at.face];
        const int row = static_cast<int>(3 * n);
        for (std::size_t k = body.traces.offset[at.face]; k < body.traces.offset[at.face + 1]; ++k)
            add_block(trace, row, 3 * body.traces.particle[k], Eigen::Matrix3d(body.traces.weight[k] * at.mask.asDiagonal()));
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                reaction.emplace_back(row + a, 9 * face.inside + 3 * a + b, face.area[b] / body.particles.volume[face.inside]);
        add_block(penalty, row, row, energy.nitsche[n]);
    }
    const Eigen::Index rows = 3 * static_cast<Eigen::Index>(energy.prescribed.size()), particles = body.particles.size();
    return {to_matrix(rows, 3 * particles, trace), to_matrix(rows, 9 * particles, reaction), to_matrix(rows, rows, penalty)};
}

}  // namespace

Eigen::SparseMatrix<double> assemble_stiffness(const QuadraticEnergy& energy) {
    const Sparse gradients = gradient_matrix(*energy.body);
    const Sparse stresses = stress_matrix(*energy.body) * gradients;
    const Sparse links = link_matrix(energy, gradients);
    Sparse stiffness = Sparse(gradients.transpose() * stresses) + Sparse(links.transpose() * links);
    if (energy.prescribed.empty()) return stiffness;
    const PrescribedRows rows = prescribed_rows(energy);
    const Sparse work = Sparse(rows.trace.transpose() * Sparse(rows.reaction * stresses));
    stiffness += Sparse(rows.trace.transpose() * Sparse(rows.penalty * rows.trace)) - work - Sparse(work.transpose());
    return stiffness;
}

Vectors solve_by_cholesky(const Eigen::SparseMatrix<double>& stiffness, const Vectors& force) {
    Eigen::CholmodSupernodalLLT<Sparse> factor;
    factor.cholmod().nmethods = 1;
    factor.cholmod().method[0].ordering = CHOLMOD_AMD;  // not METIS, which catches SIGTERM and then leaves another ordering
    factor.compute(stiffness);
    if (factor.info() != Eigen::Success) throw std::runtime_error("a positive definite stiffness matrix (CHOLMOD's factorisation failed)");
    const Eigen::Map<const Eigen::VectorXd> right(force.front().data(), 3 * static_cast<Eigen::Index>(force.size()));
    const Eigen::VectorXd solution = factor.solve(right);
    Vectors displacement(force.size());
    for (std::size_t i = 0; i < force.size(); ++i) displacement[i] = solution.segment<3>(3 * static_cast<Eigen::Index>(i));
    return displacement;
}

}  // namespace cleave::elasticity
