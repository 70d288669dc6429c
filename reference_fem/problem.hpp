#pragma once

#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

/// The finite element reference: linear elasticity of any anisotropy on tetrahedra. It shares no code with the solver;
/// this header is plain data. SI units; Voigt order xx, yy, zz, yz, xz, xy with engineering shear strain.
namespace cleave::fem {

using Point = std::array<double, 3>;
using Voigt = std::array<double, 6>;
using Stiffness = std::array<std::array<double, 6>, 6>;  ///< Pa; maps engineering strain to stress
using VectorField = std::function<Point(const Point&)>;

/// Bad mesh, unknown surface, unconstrained body, ...: what() is one line that names the file or the item.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The stiffness of the cells of one physical volume, already in the axes of the mesh.
struct Region {
    int id = 0;  ///< tag of the physical volume in the .msh; cells outside any physical volume have tag 0
    Stiffness stiffness{};
};

/// Force per area on a surface, Pa, as a function of place.
struct Traction {
    int surface = 0;
    VectorField value;
};

/// Pa; positive pushes into the body.
struct Pressure {
    int surface = 0;
    double value = 0;
};

/// Prescribed displacement, m, of the named components. Holds at every node of the surface.
/// Where two surfaces meet, their values must agree.
struct Displacement {
    int surface = 0;
    std::array<bool, 3> components{true, true, true};
    VectorField value;
};

/// Prescribed displacement, m, of the mesh vertex nearest to a point; six well-chosen components (3-2-1) hold a body without stressing it.
struct Support {
    Point point{};
    std::array<bool, 3> components{true, true, true};
    Point value{};
};

/// One static load case. Surfaces are named by their physical surface tag; a face may belong to several.
struct Problem {
    std::string mesh_file;  ///< Gmsh .msh, version 2.2 or 4.1, ASCII
    std::vector<Region> regions;
    std::vector<Traction> tractions;
    std::vector<Pressure> pressures;
    std::vector<Displacement> displacements;
    std::vector<Support> supports;
    VectorField body_force;  ///< N/m^3; may be empty
};

enum class Solver {
    automatic,  ///< direct up to Options::direct_limit unknowns, iterative above
    direct,     ///< sparse Cholesky (CHOLMOD, METIS ordering)
    iterative   ///< conjugate gradients, preconditioned by Gauss-Seidel on the nodes and a Cholesky solve on the vertices
};

struct Options {
    int degree = 2;  ///< 1 or 2; degree 2 is the reference, degree 1 is there to be compared
    Solver solver = Solver::automatic;
    long direct_limit = 50000;  ///< unknowns; a compact body of so many takes CHOLMOD about twice as long as the iterative solver
    double tolerance = 1e-11;   ///< |A x - b| / |b| at which the iterative solver stops
    int iteration_limit = 2000;
    double outside_tolerance = 0.1;  ///< how far outside the mesh a point may be evaluated, in diameters of the nearest cell
};

}  // namespace cleave::fem
