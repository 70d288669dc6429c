#pragma once

#include "reference_fem/constitutive.hpp"
#include "reference_fem/mesh.hpp"
#include "reference_fem/sparse_solver.hpp"

#include <map>
#include <memory>
#include <span>
#include <vector>

namespace cleave::fem {

/// deal.II's triangulation, elements and unknowns, behind an interface without its headers.
/// Each node of a cell (4 vertices, and 6 edge midpoints at degree 2) carries one unknown per displacement component.
class Discretization {
public:
    /// The mesh must outlive this object.
    Discretization(const Mesh& mesh, int degree);
    ~Discretization();
    Discretization(const Discretization&) = delete;
    Discretization& operator=(const Discretization&) = delete;

    struct Impl;
    const Impl& impl() const { return *impl_; }

    int dofs() const;
    int nodes_per_cell() const;
    int dof(int cell, int node, int component) const {
        return table_[3 * (static_cast<std::size_t>(cell) * nodes_per_cell() + node) + component];
    }

    /// Barycentric coordinates of a cell's nodes.
    const std::vector<std::array<double, 4>>& node_barycentrics() const { return node_barycentrics_; }

    /// The nodes of a cell on the edge between two of its vertices: the ends, then at degree 2 the midpoint.
    std::vector<int> edge_nodes(const std::array<int, 2>& ends) const;

    /// Values and reference gradients of the nodes' shape functions at a point of the unit tet.
    void shape(const Point& unit, std::span<double> values, std::span<Point> gradients) const;

    struct Quadrature {
        std::vector<Point> points;    ///< in the unit tet
        std::vector<double> weights;  ///< sum 1/6
    };
    /// deal.II's QGaussSimplex: `order` 1 to 4 gives 1, 6, 14, 35 points, exact to degree 1, 3, 5, 7.
    static Quadrature quadrature(int order);

private:
    std::unique_ptr<Impl> impl_;
    std::vector<int> table_;  // [cell][node][component]
    std::vector<std::array<double, 4>> node_barycentrics_;
};

/// Loads with their surfaces resolved to faces; one of traction and stress, or neither for a pressure.
struct SurfaceLoad {
    std::vector<BoundaryFace> faces;
    VectorField traction;  ///< Pa
    StressField stress;    ///< Pa; acts as stress times outward normal
    double pressure = 0;   ///< Pa
};

/// Prescribed values by dof; ordered, so that messages and rounding do not depend on a hash.
using PrescribedValues = std::map<int, double>;

/// Nodal loads, N, of all dofs: int f v + int t v. Throws Error if a load is not finite.
std::vector<double> nodal_loads(const Discretization& space, const VectorField& body_force, const std::vector<SurfaceLoad>& loads);

/// The linear system of the free dofs.
struct Assembly {
    SparseSystem system;
    std::vector<int> free_dofs;  ///< dof of each row
};

/// Assembles int sigma(u) : grad(v) = load . v (weak form of balance), with prescribed values eliminated.
/// `materials` holds one entry per cell.
Assembly assemble(const Discretization& space, const std::vector<const Elasticity*>& materials, const std::vector<double>& load,
                  const PrescribedValues& prescribed);

}  // namespace cleave::fem
