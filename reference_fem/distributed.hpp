#pragma once

#include "reference_fem/problem.hpp"
#include "reference_fem/solution.hpp"

#include <memory>

namespace cleave::fem {

/// MPI for the life of this object, one per program; with one process no mpirun is needed.
class MpiSession {
public:
    MpiSession(int& argc, char**& argv);
    ~MpiSession();
    MpiSession(const MpiSession&) = delete;
    MpiSession& operator=(const MpiSession&) = delete;
    int rank() const;
    int size() const;
    /// Waits for all ranks.
    void barrier() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// `solve`, spread over the ranks of an MpiSession: cells by METIS (parallel::fullydistributed::Triangulation), assembly and conjugate
/// gradients by each on its own part, preconditioned by Trilinos' algebraic multigrid (ML). Mesh and solution are whole on every rank.
/// To be called by all ranks. Options::solver does not count. Displacements equal those of `solve` to the tolerance of the iteration.
Solution solve_distributed(const Problem& problem, const Options& options = {});

}  // namespace cleave::fem
