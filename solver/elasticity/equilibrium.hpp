#pragma once

#include "solver/elasticity/conforming_body.hpp"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

namespace cleave::elasticity {

/// A field over space, m in.
using VectorField = std::function<Eigen::Vector3d(const Eigen::Vector3d& position)>;

/// A field over a surface: position (m) and outward unit normal in.
using SurfaceField = std::function<Eigen::Vector3d(const Eigen::Vector3d& position, const Eigen::Vector3d& normal)>;

/// Surfaces are named by the ids of mesh::TetMesh::surface; both lips of a crack may share one id.
struct Traction {
    int surface = 0;
    SurfaceField value;  ///< Pa
};

struct Pressure {
    int surface = 0;
    double value = 0;  ///< Pa, pushes into the body where positive
};

struct PrescribedDisplacement {
    int surface = 0;
    std::array<bool, 3> components{true, true, true};  ///< which of x, y, z are prescribed; the others are free of traction
    VectorField value;                                 ///< m
};

struct EquilibriumProblem {
    const mesh::TetMesh& mesh;                         ///< must outlive the solve; faces without a link are the boundary, cracks included
    std::map<int, material::Stiffness> stiffness{};    ///< Pa, by region
    std::map<int, double> density{};                   ///< kg/m^3, by region; asked for by free bodies only, 1 where missing
    std::vector<Traction> tractions{};
    std::vector<Pressure> pressures{};
    std::vector<PrescribedDisplacement> displacements{};
    VectorField body_force{};                          ///< N/m^3; may be empty
    bool free_body = false;  ///< nothing holds the body: its acceleration balances the load (inertia relief)
};

/// Size of the link penalty of every solve: chosen once, by the manufactured solution and the penny crack together, never per case.
/// Measured (link penalty 1, 2, 3): penny crack, 19.4k particles: G +5.7, +5.4, +5.1 %; triclinic waves, 4,923 particles, all sides held
/// (2, 3): stress 5.49, 5.44 %, recovered 2.98, 2.90 %, displacement 1.59, 1.54 %; iterations 59, 66. Larger values go on that way slowly,
/// but the penalty is there against modes that the strain does not see, not to make up for a soft body. The support of the traces matters
/// less: ratios 1.2, 1.6, 2.0 give stress 5.8, 5.5, 5.5 %, and G the same to 0.1 %.
inline constexpr double default_link_penalty = 3;

enum class EquilibriumSolver {
    conjugate_gradients,  ///< matrix-free, any size
    cholesky              ///< assembled, CHOLMOD: held bodies of a few thousand particles; the check of the other
};

struct EquilibriumOptions {
    TraceRule traces{};
    double link_penalty = default_link_penalty;
    EquilibriumSolver solver = EquilibriumSolver::conjugate_gradients;
    double tolerance = 1e-10;    ///< of the residual over the load
    int max_iterations = 20000;
};

/// What a boundary face shows: the opening of a crack, surface displacements.
struct BoundaryTrace {
    int surface;  ///< id, -1 where the mesh tags none
    Eigen::Vector3d position, normal;
    double area;
    Eigen::Vector3d displacement;
};

struct EquilibriumReport {
    TraceReport traces;
    int iterations = 0;
    double residual = 0;  ///< |f - K u| / |f|, evaluated anew from the solution
};

struct EquilibriumSolution {
    std::shared_ptr<const ConformingBody> body;  ///< its particles, faces and traces
    std::vector<Eigen::Vector3d> displacement;  ///< m
    Fields fields;                              ///< gradient, strain, stress (Pa), strain energy (J) of each particle, as solved
    Fields recovered;                           ///< the same smoothed (recovered_fields): half the error where the stress is smooth
    double strain_energy = 0;     ///< J, sum of V eps:C:eps / 2
    double link_energy = 0;       ///< J, of the link penalty: small where the field is resolved
    double external_work = 0;     ///< J, tractions, pressures and body forces times their displacement; twice the energy where nothing is
                                  ///< prescribed but zero
    double potential = 0;         ///< J, of body and loads: what equilibrium makes stationary
    std::vector<Eigen::Vector3d> acceleration;  ///< m/s^2 of the particles of a free body; empty otherwise
    std::vector<BoundaryTrace> boundary;
    EquilibriumReport report;
};

/// Rounding rules: a stiffness or a mesh of so bad a condition that the iteration does not reach its tolerance. what() is one line.
struct NotConverged : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Equilibrium of the `conforming` particles under dead loads. Throws std::invalid_argument, one line: a region without stiffness, a
/// surface id on no boundary face, a component prescribed twice, a piece of the body that nothing holds (and free_body not set),
/// free_body beside prescribed displacements. Throws NotConverged where the iteration does not reach the tolerance.
EquilibriumSolution solve_equilibrium(const EquilibriumProblem& problem, const EquilibriumOptions& options = {});

/// |f - K u| / |f| of a given displacement (m per particle, not a solved one): what the discrete balance makes of a known field. Zero to
/// rounding for a linear field in a homogeneous body (the weak patch test). Throws as solve_equilibrium does, and std::invalid_argument
/// for a free body or a displacement of another size.
double balance_residual(const EquilibriumProblem& problem, const std::vector<Eigen::Vector3d>& displacement,
                        const EquilibriumOptions& options = {});

}  // namespace cleave::elasticity
