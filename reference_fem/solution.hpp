#pragma once

#include "reference_fem/problem.hpp"

#include <memory>

namespace cleave::fem {

/// What one solve cost and how well it did.
struct SolveRecord {
    long cells = 0;
    long dofs = 0;                 ///< nodal components, prescribed ones included
    std::string solver;            ///< "cholmod", "cg+two_level" or "cg+ml"
    int iterations = 0;            ///< 0 for the direct solver
    double relative_residual = 0;  ///< |A x - b| / |b| over the free components, after the solve
    double seconds = 0;            ///< reading, assembly and solve; a timing, hence not reproducible
    double matrix_bytes = 0;       ///< matrix and factor or preconditioner
};

/// The fields at one place.
struct FieldSample {
    Point position{};      ///< m
    double weight = 0;     ///< quadrature weight, m^3; 0 for point samples
    int region = 0;        ///< tag of the physical volume
    Point displacement{};  ///< m
    std::array<Point, 3> gradient{};  ///< gradient[i][j] = du_i/dx_j
    Voigt strain{};        ///< engineering shear
    Voigt stress{};        ///< Pa
    int cell = 0;          ///< in the order of the file
};

/// The fields at a place of a surface; the weight is an area, m^2.
struct SurfaceSample : FieldSample {
    Point normal{};  ///< outward unit normal
};

class Elasticity;

/// The solution of one Problem: a handle, cheap to copy and safe to read from several threads.
class Solution {
public:
    struct Data;
    explicit Solution(std::shared_ptr<const Data> data);

    const SolveRecord& record() const;

    /// The fields at the quadrature points of all cells, cells in the order of the file. `order` 1 to 4 gives 1, 6, 14 or 35 points a cell,
    /// exact for polynomials of degree 1, 3, 5, 7. The weights sum to the volume of the mesh.
    std::vector<FieldSample> quadrature_samples(int order = 3) const;

    /// The fields at a point, from the shape functions of the cell that holds it: displacement to O(h^3), stress to O(h^2) and
    /// discontinuous between cells (degree 2). On a face shared by cells the one of lowest index counts.
    /// A point outside the mesh is evaluated in the nearest cell if it is within Options::outside_tolerance of that cell's diameter
    /// (the mesh has flat faces, so a point on a curved boundary may lie outside); beyond that: Error.
    FieldSample at(const Point& point) const;
    std::vector<FieldSample> at(const std::vector<Point>& points) const;

    /// As `at`, but strain and stress are recovered: at each vertex of the cell a quadratic is fitted by least squares to the strain at the
    /// quadrature points of the cells around the vertex (superconvergent patch recovery, Zienkiewicz and Zhu 1992, Int. J. Numer. Meth.
    /// Eng. 33, 1331), and the four quadratics are blended with the barycentric coordinates of the point: continuous within a region,
    /// third order where `at` is second. Patches never cross into another region. Beside a curved boundary flat faces limit both
    /// to first order: at the edge of a hole in material M the two differ by less than their error (4 % rms at size a/28, on the tensor).
    std::vector<FieldSample> recovered_at(const std::vector<Point>& points) const;

    /// As quadrature_samples, of some cells only, one after the other.
    std::vector<FieldSample> cell_samples(const std::vector<int>& cells, int order = 3) const;
    /// The fields on the faces of a physical surface, from the cells behind them, of cells that are `wanted` (empty: all). 72 points a face,
    /// exact to degree 4 and for such polynomials over the square root of the distance from an edge. Throws Error.
    std::vector<SurfaceSample> surface_samples(int surface, const std::function<bool(int cell)>& wanted = {}) const;
    /// Tags of the physical surfaces, ascending.
    std::vector<int> surfaces() const;
    /// The material of a cell; it lives as long as the solution.
    const Elasticity& material(int cell) const;

    std::vector<std::array<int, 4>> cells() const;  ///< numbers of their vertices
    std::vector<Point> vertices() const;              ///< m; vertices of tets, in the order of the file
    std::vector<Point> vertex_displacements() const;  ///< m; one per vertex

    /// Estimated error of each cell in the energy norm, sqrt(J): the square root of int (e* - e) : C : (e* - e) dV, with e* the recovered strain
    /// of `recovered_at` (Zienkiewicz and Zhu 1987, Int. J. Numer. Meth. Eng. 24, 337).
    std::vector<double> cell_errors() const;
    /// The estimate of the whole body over the norm of the solution: sqrt(sum of squares / (2 energy)).
    double estimated_error() const;

    /// Strain energy, J: integral of stress : strain / 2.
    double energy() const;
    /// Work, J, of tractions, pressures and body force and of the reactions at prescribed displacements, taken at the final load:
    /// twice the energy for a solution in balance.
    double external_work() const;

    const Data& data() const { return *data_; }  ///< for this folder's own use

private:
    std::shared_ptr<const Data> data_;
};

}  // namespace cleave::fem
