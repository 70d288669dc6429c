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
using StressField = std::function<Voigt(const Point&)>;
using Frame = std::array<Point, 3>;  ///< unit vectors of three right-handed material axes, in the axes of the mesh

/// Bad mesh, unknown surface, unconstrained body, ...: what() is one line that names the file or the item.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The material of the cells of one physical volume.
struct Region {
    int id = 0;  ///< tag of the physical volume in the .msh; cells outside any physical volume have tag 0
    Stiffness stiffness{};                           ///< in the axes of `frame`
    Frame frame{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< the axes of the mesh unless told otherwise
    double density = 0;                              ///< kg/m^3; of use for a free body only
};

/// Force per area on a surface, as a function of place: a vector, or a stress whose product with the outward normal it is.
struct Traction {
    int surface = 0;
    VectorField value{};   ///< Pa
    StressField stress{};  ///< Pa; one of the two must be given
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

/// The line in which two surfaces meet: the edges of the mesh that belong to triangles of both.
struct Line {
    int first = 0;
    int second = 0;
};

/// Prescribed displacement, m, at every node of a line.
struct LineDisplacement {
    Line line;
    std::array<bool, 3> components{true, true, true};
    VectorField value;
};

/// Force per length on a line, N/m, as a function of place.
struct LineLoad {
    Line line;
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
    std::vector<LineDisplacement> line_displacements{};
    std::vector<LineLoad> line_loads{};
    /// Nothing holds the body: the inertia of its rigid acceleration balances the loads (inertia relief), and of all displacements that
    /// differ by a rigid motion the one without linear and angular momentum is taken. Needs densities, and no prescribed displacement.
    bool free_body = false;
};

enum class Solver {
    automatic,  ///< direct up to Options::direct_limit unknowns, iterative above; direct as well where that takes more than 150 steps
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
