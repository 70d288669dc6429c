#include "reference_fem/distributed.hpp"

#include "reference_fem/assembly_impl.hpp"
#include "reference_fem/posed_problem.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <map>

namespace cleave::fem {
namespace {

using dealii::IndexSet;
using dealii::TrilinosWrappers::PreconditionAMG;
using dealii::TrilinosWrappers::SparseMatrix;
using Vector = dealii::TrilinosWrappers::MPI::Vector;
using Indices = std::vector<dealii::types::global_dof_index>;
using Cell = dealii::DoFHandler<3>::active_cell_iterator;

const MPI_Comm world = MPI_COMM_WORLD;

/// This rank's part of the mesh, with its unknowns; `ours` gives the number of each in the serial Discretization.
class DistributedSpace {
public:
    explicit DistributedSpace(const Solution::Data& data)
        : data_(data), space_(data.space.impl()), triangulation_(world), dofs_(triangulation_), local_(space_.element) {
        dealii::Triangulation<3> whole;
        fill(whole, data.mesh);
        dealii::GridTools::partition_triangulation(dealii::Utilities::MPI::n_mpi_processes(world), whole, dealii::SparsityTools::Partitioner::metis);
        triangulation_.create_triangulation(dealii::TriangulationDescription::Utilities::create_description_from_triangulation(whole, world));
        dofs_.distribute_dofs(space_.element);
        owned_ = dofs_.locally_owned_dofs();
        dealii::DoFTools::extract_locally_relevant_dofs(dofs_, relevant_);
        Indices indices(space_.element.n_dofs_per_cell());
        for (const Cell& cell : dofs_.active_cell_iterators()) {
            if (cell->is_artificial()) continue;
            cell->get_dof_indices(indices);
            for (unsigned int node = 0; node < local_.nodes; ++node)
                for (int i = 0; i < 3; ++i) ours_[indices[local_(node, i)]] = data.space.dof(number_of(cell), static_cast<int>(node), i);
        }
    }

    const dealii::DoFHandler<3>& dofs() const { return dofs_; }
    const IndexSet& owned() const { return owned_; }
    const IndexSet& relevant() const { return relevant_; }
    const std::map<dealii::types::global_dof_index, int>& ours() const { return ours_; }

    /// Place of a cell in the file: the coarse cells keep their numbers.
    int number_of(const Cell& cell) const { return static_cast<int>(cell->id().get_coarse_cell_id()); }

    dealii::AffineConstraints<double> constraints(const PrescribedValues& prescribed) const {
        dealii::AffineConstraints<double> constraints(relevant_);
        for (const auto& [dof, number] : ours_)
            if (const auto found = prescribed.find(number); found != prescribed.end()) {
                constraints.add_line(dof);
                constraints.set_inhomogeneity(dof, found->second);
            }
        constraints.close();
        return constraints;
    }

    void assemble(const dealii::AffineConstraints<double>& constraints, SparseMatrix& matrix, Vector& right) const {
        dealii::DynamicSparsityPattern pattern(relevant_);
        dealii::DoFTools::make_sparsity_pattern(dofs_, pattern, constraints, false);
        dealii::SparsityTools::distribute_sparsity_pattern(pattern, owned_, world, relevant_);
        matrix.reinit(owned_, owned_, pattern, world);
        dealii::FEValues<3> values(space_.mapping, space_.scalar, dealii::QGaussSimplex<3>(space_.scalar.degree),
                                   dealii::update_gradients | dealii::update_JxW_values);
        Indices indices(space_.element.n_dofs_per_cell());
        dealii::Vector<double> no_load(static_cast<unsigned int>(indices.size()));
        for (const Cell& cell : dofs_.active_cell_iterators()) {
            if (!cell->is_locally_owned()) continue;
            cell->get_dof_indices(indices);
            values.reinit(static_cast<dealii::Triangulation<3>::cell_iterator>(cell));
            const auto stiffness = cell_stiffness(values, local_, *data_.materials[number_of(cell)]);
            constraints.distribute_local_to_global(stiffness, no_load, indices, matrix, right);
        }
        matrix.compress(dealii::VectorOperation::add);
        right.compress(dealii::VectorOperation::add);
    }

    /// All values, in our numbering, on every rank.
    std::vector<double> gather(const Vector& values) const {
        std::vector<double> own(data_.space.dofs(), 0.0), all(data_.space.dofs(), 0.0);
        for (const auto& [dof, number] : ours_)
            if (owned_.is_element(dof)) own[number] = values(dof);
        dealii::Utilities::MPI::sum(own, world, all);
        return all;
    }

private:
    const Solution::Data& data_;
    const Discretization::Impl& space_;
    dealii::parallel::fullydistributed::Triangulation<3> triangulation_;
    dealii::DoFHandler<3> dofs_;
    LocalNumbers local_;
    IndexSet owned_, relevant_;
    std::map<dealii::types::global_dof_index, int> ours_;  // of the dofs of owned and ghost cells
};

/// Settings measured in the prototype: 183,000 unknowns in 18 s on one core.
PreconditionAMG::AdditionalData multigrid_settings(const DistributedSpace& space, int degree) {
    PreconditionAMG::AdditionalData settings;
    settings.elliptic = true;
    settings.higher_order_elements = degree > 1;
    settings.smoother_sweeps = 2;
    settings.aggregation_threshold = 0.02;
    dealii::DoFTools::extract_constant_modes(space.dofs(), dealii::ComponentMask(3, true), settings.constant_modes);
    return settings;
}

}  // namespace

struct MpiSession::Impl {
    Impl(int& argc, char**& argv) : session(argc, argv, 1) {}  // one thread: sums in one order
    dealii::Utilities::MPI::MPI_InitFinalize session;
};
MpiSession::MpiSession(int& argc, char**& argv) : impl_(std::make_unique<Impl>(argc, argv)) {}
MpiSession::~MpiSession() = default;
int MpiSession::rank() const { return static_cast<int>(dealii::Utilities::MPI::this_mpi_process(world)); }
int MpiSession::size() const { return static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(world)); }
void MpiSession::barrier() const { MPI_Barrier(world); }

Solution solve_distributed(const Problem& problem, const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    PosedProblem posed(problem, options);
    const DistributedSpace space(posed.data());
    const auto constraints = space.constraints(posed.prescribed());
    SparseMatrix matrix;
    Vector right(space.owned(), world), values(space.owned(), world), rest(space.owned(), world);
    space.assemble(constraints, matrix, right);
    for (const auto dof : space.owned())
        if (!constraints.is_constrained(dof)) right(dof) += posed.load()[space.ours().at(dof)];
    right.compress(dealii::VectorOperation::add);

    PreconditionAMG preconditioner;
    preconditioner.initialize(matrix, multigrid_settings(space, options.degree));
    dealii::SolverControl control(static_cast<unsigned int>(options.iteration_limit), options.tolerance * right.l2_norm());
    try {
        dealii::SolverCG<Vector>(control).solve(matrix, values, right, preconditioner);
    } catch (const dealii::SolverControl::NoConvergence&) {
        throw Error(fmt::format("conjugate gradients: residual {:.1e} after {} iterations", control.last_value() / right.l2_norm(), control.last_step()));
    }
    const double residual = matrix.residual(rest, values, right) / right.l2_norm();
    constraints.distribute(values);
    const double bytes = dealii::Utilities::MPI::sum(static_cast<double>(matrix.memory_consumption()) + preconditioner.memory_consumption(), world);
    return posed.conclude(space.gather(values),
                          {.solver = "cg+ml", .iterations = static_cast<int>(control.last_step()), .relative_residual = residual, .matrix_bytes = bytes},
                          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

}  // namespace cleave::fem
