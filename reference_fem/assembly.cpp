#include "reference_fem/assembly_impl.hpp"
#include "reference_fem/vector3.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cleave::fem {
namespace {

using dealii::AffineConstraints;
using dealii::FEFaceValues;
using dealii::FEValues;
using dealii::FullMatrix;
using dealii::QGaussSimplex;
using Indices = std::vector<dealii::types::global_dof_index>;

constexpr int load_quadrature_order = 4;  // loads are arbitrary functions: exact to degree 7 against shape functions

Point to_point(const dealii::Tensor<1, 3>& tensor) { return {tensor[0], tensor[1], tensor[2]}; }

bool is_finite(const Point& value) { return std::isfinite(value[0]) && std::isfinite(value[1]) && std::isfinite(value[2]); }

/// flow[i][k][j] = C_ikjl g_l: what the gradient g of a shape function in component j adds to the stress (i, k).
using Flow = std::array<std::array<Point, 3>, 3>;
Flow flow_of(const Elasticity& material, const Point& gradient) {
    Flow flow{};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j)
                for (int l = 0; l < 3; ++l) flow[i][k][j] += material(i, k, j, l) * gradient[l];
    return flow;
}

/// Adds int phi_a f dV (or dA) of one cell or face; `force(q)` is per volume or area.
template <class Values, class Force>
void add_load(const Values& values, const LocalNumbers& local, const Indices& dofs, const Force& force, std::vector<double>& load) {
    for (const unsigned int q : values.quadrature_point_indices()) {
        const Point density = force(q);
        if (!is_finite(density)) throw Error("a load is not finite at some point of the body");
        for (unsigned int a = 0; a < local.nodes; ++a)
            for (int i = 0; i < 3; ++i) load[dofs[local(a, i)]] += values.shape_value(a, q) * density[i] * values.JxW(q);
    }
}

void add_body_force(const Discretization::Impl& space, const LocalNumbers& local, const VectorField& body_force,
                    std::vector<double>& load) {
    FEValues<3> values(space.mapping, space.scalar, QGaussSimplex<3>(load_quadrature_order),
                       dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points);
    Indices dofs(space.element.n_dofs_per_cell());
    for (const auto& cell : space.dofs.active_cell_iterators()) {
        cell->get_dof_indices(dofs);
        values.reinit(static_cast<dealii::Triangulation<3>::cell_iterator>(cell));
        add_load(
            values, local, dofs, [&](unsigned int q) { return body_force(to_point(values.quadrature_point(q))); }, load);
    }
}

/// Number of the face opposite a vertex, in deal.II's order.
unsigned int face_opposite(const dealii::DoFHandler<3>::active_cell_iterator& cell, int opposite) {
    const auto vertex = cell->vertex_index(opposite);
    for (const unsigned int f : cell->face_indices()) {
        const auto face = cell->face(f);
        if (face->vertex_index(0) != vertex && face->vertex_index(1) != vertex && face->vertex_index(2) != vertex) return f;
    }
    throw std::logic_error("a tet without a face opposite a vertex");
}

/// Stress times normal.
Point times(const Voigt& stress, const Point& normal) {
    Point force{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) force[i] += stress[voigt_index(i, j)] * normal[j];
    return force;
}

void add_surface_loads(const Discretization::Impl& space, const LocalNumbers& local, const std::vector<SurfaceLoad>& loads,
                       std::vector<double>& load) {
    FEFaceValues<3> values(
        space.mapping, space.scalar, QGaussSimplex<2>(load_quadrature_order),
        dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points | dealii::update_normal_vectors);
    std::vector<dealii::DoFHandler<3>::active_cell_iterator> cells;
    for (const auto& cell : space.dofs.active_cell_iterators()) cells.push_back(cell);
    Indices dofs(space.element.n_dofs_per_cell());
    for (const SurfaceLoad& surface : loads)
        for (const BoundaryFace& face : surface.faces) {
            const auto& cell = cells[face.cell];
            cell->get_dof_indices(dofs);
            values.reinit(static_cast<dealii::Triangulation<3>::cell_iterator>(cell), face_opposite(cell, face.opposite));
            const auto force = [&](unsigned int q) {
                const Point place = to_point(values.quadrature_point(q)), normal = to_point(values.normal_vector(q));
                if (surface.traction) return surface.traction(place);
                return surface.stress ? times(surface.stress(place), normal) : -surface.pressure * normal;
            };
            add_load(values, local, dofs, force, load);
        }
}

AffineConstraints<double> constraints_of(const PrescribedValues& prescribed) {
    AffineConstraints<double> constraints;
    for (const auto& [dof, value] : prescribed) {
        constraints.add_line(dof);
        constraints.set_inhomogeneity(dof, value);
    }
    constraints.close();
    return constraints;
}

/// Rows and columns of the free dofs, columns ascending (deal.II keeps the diagonal first).
SparseSystem extract(const dealii::SparseMatrix<double>& matrix, const dealii::Vector<double>& right_hand_side,
                     const std::vector<int>& free_dofs, const std::vector<int>& row_of) {
    SparseSystem system;
    system.row_start.push_back(0);
    std::vector<std::pair<int, double>> row;
    for (const int dof : free_dofs) {
        row.clear();
        for (auto entry = matrix.begin(dof); entry != matrix.end(dof); ++entry)
            if (row_of[entry->column()] >= 0) row.emplace_back(row_of[entry->column()], entry->value());
        std::sort(row.begin(), row.end());
        for (const auto& [column, value] : row) {
            system.column.push_back(column);
            system.value.push_back(value);
        }
        system.row_start.push_back(static_cast<int>(system.column.size()));
        system.right_hand_side.push_back(right_hand_side[dof]);
    }
    return system;
}

/// See SparseSystem::parents.
std::vector<std::array<int, 2>> parents_of(const Discretization& space, int cells, int rows, const std::vector<int>& row_of) {
    std::vector<std::array<int, 2>> parents(rows, {-1, -1});
    const auto& nodes = space.node_barycentrics();
    for (int cell = 0; cell < cells; ++cell)
        for (int node = 0; node < space.nodes_per_cell(); ++node)
            for (int component = 0; component < 3; ++component) {
                const int row = row_of[space.dof(cell, node, component)];
                if (row < 0) continue;
                int next = 0;
                for (int vertex = 0; vertex < 4; ++vertex)
                    for (int half = 0; half < std::lround(2 * nodes[node][vertex]); ++half)
                        parents[row][next++] = row_of[space.dof(cell, vertex, component)];
            }
    return parents;
}

}  // namespace

std::vector<double> nodal_loads(const Discretization& space, const VectorField& body_force, const std::vector<SurfaceLoad>& loads) {
    const Discretization::Impl& impl = space.impl();
    const LocalNumbers local(impl.element);
    std::vector<double> load(impl.dofs.n_dofs(), 0.0);
    if (body_force) add_body_force(impl, local, body_force, load);
    add_surface_loads(impl, local, loads, load);
    return load;
}

FullMatrix<double> cell_stiffness(const FEValues<3>& values, const LocalNumbers& local, const Elasticity& material) {
    FullMatrix<double> matrix(3 * local.nodes);
    for (const unsigned int q : values.quadrature_point_indices())
        for (unsigned int b = 0; b < local.nodes; ++b) {
            const Flow flow = flow_of(material, to_point(values.JxW(q) * values.shape_grad(b, q)));
            for (unsigned int a = 0; a < local.nodes; ++a) {
                const Point gradient = to_point(values.shape_grad(a, q));
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j)
                        for (int k = 0; k < 3; ++k) matrix(local(a, i), local(b, j)) += gradient[k] * flow[i][k][j];
            }
        }
    return matrix;
}

Assembly assemble(const Discretization& space, const std::vector<const Elasticity*>& materials, const std::vector<double>& load,
                  const PrescribedValues& prescribed) {
    const Discretization::Impl& impl = space.impl();
    const LocalNumbers local(impl.element);
    const unsigned int size = impl.dofs.n_dofs();

    Assembly result;
    const AffineConstraints<double> constraints = constraints_of(prescribed);
    dealii::SparsityPattern pattern;
    {
        dealii::DynamicSparsityPattern dynamic(size);
        dealii::DoFTools::make_sparsity_pattern(impl.dofs, dynamic, constraints, false);
        pattern.copy_from(dynamic);
    }
    dealii::SparseMatrix<double> matrix(pattern);
    dealii::Vector<double> right_hand_side(load.begin(), load.end());

    FEValues<3> values(impl.mapping, impl.scalar, QGaussSimplex<3>(impl.scalar.degree),
                       dealii::update_gradients | dealii::update_JxW_values);
    Indices dofs(impl.element.n_dofs_per_cell());
    dealii::Vector<double> no_load(static_cast<unsigned int>(dofs.size()));
    for (const auto& cell : impl.dofs.active_cell_iterators()) {
        cell->get_dof_indices(dofs);
        values.reinit(static_cast<dealii::Triangulation<3>::cell_iterator>(cell));
        const FullMatrix<double> stiffness = cell_stiffness(values, local, *materials[cell->active_cell_index()]);
        constraints.distribute_local_to_global(stiffness, no_load, dofs, matrix, right_hand_side);
    }

    std::vector<int> row_of(size, -1);
    for (int dof = 0; dof < static_cast<int>(size); ++dof) {
        if (prescribed.contains(dof)) continue;
        row_of[dof] = static_cast<int>(result.free_dofs.size());
        result.free_dofs.push_back(dof);
    }
    result.system = extract(matrix, right_hand_side, result.free_dofs, row_of);
    result.system.parents = parents_of(space, static_cast<int>(materials.size()), result.system.size(), row_of);
    return result;
}

}  // namespace cleave::fem
