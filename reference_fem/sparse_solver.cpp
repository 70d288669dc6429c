#include "reference_fem/sparse_solver.hpp"

#include "reference_fem/problem.hpp"

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>
#include <fmt/format.h>

#include <dlfcn.h>
#include <signal.h>

#include <algorithm>
#include <cmath>

namespace cleave::fem {
namespace {

using Vector = Eigen::VectorXd;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;
using RowMatrixView = Eigen::Map<const RowMatrix>;
using ColumnMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

RowMatrixView matrix_of(const SparseSystem& system) {
    return {system.size(),           system.size(),        static_cast<int>(system.value.size()),
            system.row_start.data(), system.column.data(), system.value.data()};
}

Eigen::Map<const Vector> vector_of(const std::vector<double>& values) { return {values.data(), static_cast<Eigen::Index>(values.size())}; }

/// Threads of BLAS change the order of its sums. OpenBLAS is asked by name, if it is what was loaded: other libraries have one thread.
void hold_blas_to_one_thread() {
    using SetThreads = void (*)(int);
    if (const auto set_threads = reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))) set_threads(1);
}

/// Holds SIGTERM back from this thread while METIS runs, which takes that signal for its own errors: a request to end would be swallowed,
/// and CHOLMOD would go on with another ordering, whose results differ in the last digits. The signal is then for after METIS; where the
/// kernel gives it to another thread meanwhile (of BLAS, of OpenMP), METIS's handler ends the process there by a segmentation fault.
class TerminationHeld {
public:
    TerminationHeld() {
        sigset_t held;
        sigemptyset(&held);
        sigaddset(&held, SIGTERM);
        pthread_sigmask(SIG_BLOCK, &held, &before_);
    }
    ~TerminationHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    TerminationHeld(const TerminationHeld&) = delete;
    TerminationHeld& operator=(const TerminationHeld&) = delete;

private:
    sigset_t before_;
};

/// CHOLMOD's factor L L^T through Eigen's wrapper.
class Cholesky : public Eigen::CholmodSupernodalLLT<ColumnMatrix, Eigen::Lower> {
public:
    explicit Cholesky(const ColumnMatrix& lower) {
        hold_blas_to_one_thread();
        cholmod().nmethods = 1;
        cholmod().method[0].ordering = CHOLMOD_METIS;
        cholmod().postorder = 1;
        cholmod().print = 0;
        {
            const TerminationHeld held;
            analyzePattern(lower);
        }
        factorize(lower);
        if (info() != Eigen::Success || cholmod_rcond(m_cholmodFactor, &cholmod()) < 1e-15)
            throw Error("the stiffness matrix is singular: the body, or a part of it, can move without strain");
    }

    double bytes() { return static_cast<double>(m_cholmodFactor->xsize) * sizeof(double); }
};

/// The upper triangle by rows is, read by columns, the lower one.
template <class Matrix>
ColumnMatrix lower_triangle(const Matrix& matrix) {
    const RowMatrix upper = matrix.template triangularView<Eigen::Upper>();
    return upper.transpose();
}

double bytes_of(const SparseSystem& system) { return static_cast<double>(system.value.size()) * (sizeof(double) + sizeof(int)); }

double relative_norm(const Vector& residual, const Vector& reference) {
    return reference.norm() > 0 ? residual.norm() / reference.norm() : residual.norm();
}

/// Mean of the vertex rows, one column per vertex row.
RowMatrix prolongation(const SparseSystem& system) {
    std::vector<int> coarse(system.parents.size(), -1);
    int coarse_size = 0;
    for (int row = 0; row < system.size(); ++row)
        if (system.parents[row] == std::array{row, row}) coarse[row] = coarse_size++;
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < system.size(); ++row)
        for (const int parent : system.parents[row])
            if (parent >= 0) entries.emplace_back(row, coarse[parent], 0.5);  // entries of a vertex row add up to 1
    RowMatrix matrix(system.size(), coarse_size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// The preconditioner of solve_iterative.
class TwoLevel {
public:
    TwoLevel(const RowMatrixView& matrix, RowMatrix prolongation)
        : matrix_(matrix),
          inverse_diagonal_(matrix.rows()),
          prolongation_(std::move(prolongation)),
          restriction_(prolongation_.transpose()),
          coarse_(lower_triangle(RowMatrix(restriction_ * matrix_ * prolongation_))) {
        for (int row = 0; row < matrix_.rows(); ++row) inverse_diagonal_[row] = 1 / matrix_.coeff(row, row);
    }

    Vector apply(const Vector& residual) {
        Vector correction = Vector::Zero(residual.size());
        for (int row = 0; row < matrix_.rows(); ++row) relax(row, residual, correction);
        correction += prolongation_ * coarse_.solve(restriction_ * (residual - matrix_ * correction));
        for (int row = static_cast<int>(matrix_.rows()) - 1; row >= 0; --row) relax(row, residual, correction);
        return correction;
    }

    double bytes() { return coarse_.bytes(); }

private:
    /// One Gauss-Seidel step: solves the row for its own unknown.
    void relax(int row, const Vector& residual, Vector& correction) const {
        double rest = residual[row];
        for (RowMatrixView::InnerIterator entry(matrix_, row); entry; ++entry) rest -= entry.value() * correction[entry.col()];
        correction[row] += inverse_diagonal_[row] * rest;
    }

    RowMatrixView matrix_;
    Vector inverse_diagonal_;
    RowMatrix prolongation_;
    RowMatrix restriction_;
    Cholesky coarse_;
};

}  // namespace

SparseSolution solve_direct(const SparseSystem& system) {
    SparseSolution solution{.values = {}, .solver = "cholmod", .bytes = bytes_of(system)};
    if (system.size() == 0) return solution;
    const RowMatrixView matrix = matrix_of(system);
    const Vector right_hand_side = vector_of(system.right_hand_side);
    Cholesky factor(lower_triangle(matrix));
    Vector values = factor.solve(right_hand_side);
    values += factor.solve(right_hand_side - matrix * values);
    solution.values.assign(values.begin(), values.end());
    solution.relative_residual = relative_norm(right_hand_side - matrix * values, right_hand_side);
    solution.bytes += factor.bytes();
    return solution;
}

struct DirectFactor::Impl {
    explicit Impl(const SparseSystem& system) : factor(lower_triangle(matrix_of(system))), bytes(bytes_of(system) + factor.bytes()) {}
    Cholesky factor;
    double bytes;
};

DirectFactor::DirectFactor(const SparseSystem& system) : impl_(std::make_unique<Impl>(system)) {}
DirectFactor::~DirectFactor() = default;

double DirectFactor::bytes() const { return impl_->bytes; }

std::vector<double> DirectFactor::solve(const std::vector<double>& right_hand_side) {
    const Vector values = impl_->factor.solve(vector_of(right_hand_side));
    return {values.begin(), values.end()};
}

std::vector<double> DirectFactor::inverse_block(const std::vector<int>& rows) {
    constexpr std::size_t columns_at_once = 64;  // enough for the dense kernels, little enough for the memory
    std::vector<double> block(rows.size() * rows.size());
    for (std::size_t first = 0; first < rows.size(); first += columns_at_once) {
        const std::size_t count = std::min(columns_at_once, rows.size() - first);
        Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(impl_->factor.rows(), static_cast<Eigen::Index>(count));
        for (std::size_t k = 0; k < count; ++k) unit(rows[first + k], static_cast<Eigen::Index>(k)) = 1;
        const Eigen::MatrixXd column = impl_->factor.solve(unit);
        for (std::size_t row = 0; row < rows.size(); ++row)
            for (std::size_t k = 0; k < count; ++k) block[row * rows.size() + first + k] = column(rows[row], static_cast<Eigen::Index>(k));
    }
    return block;
}

SparseSolution solve_iterative(const SparseSystem& system, double tolerance, int iteration_limit) {
    SparseSolution solution{.values = {}, .solver = "cg+two_level", .bytes = bytes_of(system)};
    if (system.size() == 0) return solution;
    const RowMatrixView matrix = matrix_of(system);
    const Vector right_hand_side = vector_of(system.right_hand_side);
    TwoLevel preconditioner(matrix, prolongation(system));
    Vector values = Vector::Zero(system.size());
    Vector residual = right_hand_side;
    Vector direction = Vector::Zero(system.size());
    double previous = 1;
    while (residual.norm() > tolerance * right_hand_side.norm()) {
        if (solution.iterations++ == iteration_limit)
            throw Error(fmt::format("conjugate gradients: residual {:.1e} after {} iterations", relative_norm(residual, right_hand_side),
                                    iteration_limit));
        const Vector preconditioned = preconditioner.apply(residual);
        const double current = residual.dot(preconditioned);
        direction = preconditioned + current / previous * direction;
        const Vector image = matrix * direction;
        const double step = current / direction.dot(image);
        values += step * direction;
        residual -= step * image;
        previous = current;
    }
    solution.values.assign(values.begin(), values.end());
    solution.relative_residual = relative_norm(right_hand_side - matrix * values, right_hand_side);
    solution.bytes += preconditioner.bytes();
    return solution;
}

}  // namespace cleave::fem
