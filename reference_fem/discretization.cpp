#include "reference_fem/discretization_impl.hpp"

#include <deal.II/base/quadrature_lib.h>

namespace cleave::fem {
namespace {

dealii::Point<3> to_deal_ii(const Point& point) { return {point[0], point[1], point[2]}; }

/// Our cell data are looked up by deal.II's active cell index and local vertex number: both must be as in the file.
void check_numbering(const dealii::Triangulation<3>& triangulation, const Mesh& mesh) {
    for (const auto& cell : triangulation.active_cell_iterators())
        for (int i = 0; i < 4; ++i)
            if (static_cast<int>(cell->vertex_index(i)) != mesh.cells[cell->active_cell_index()][i])
                throw std::logic_error("deal.II renumbered the mesh");
}

}  // namespace

void fill(dealii::Triangulation<3>& triangulation, const Mesh& mesh) {
    std::vector<dealii::Point<3>> vertices;
    for (const Point& vertex : mesh.vertices) vertices.push_back(to_deal_ii(vertex));
    std::vector<dealii::CellData<3>> cells;
    for (const auto& cell : mesh.cells) {
        dealii::CellData<3> data(4);
        for (int i = 0; i < 4; ++i) data.vertices[i] = cell[i];
        cells.push_back(data);
    }
    triangulation.create_triangulation(vertices, cells, {});
}

Discretization::Discretization(const Mesh& mesh, int degree) : impl_(std::make_unique<Impl>(degree)) {
    fill(impl_->triangulation, mesh);
    check_numbering(impl_->triangulation, mesh);
    impl_->dofs.reinit(impl_->triangulation);
    impl_->dofs.distribute_dofs(impl_->element);

    const auto& element = impl_->element;
    table_.resize(mesh.cells.size() * element.n_dofs_per_cell());
    std::vector<dealii::types::global_dof_index> dofs(element.n_dofs_per_cell());
    for (const auto& cell : impl_->dofs.active_cell_iterators()) {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i) {
            const auto [component, node] = element.system_to_component_index(i);
            table_[static_cast<std::size_t>(cell->active_cell_index()) * dofs.size() + 3 * node + component] = static_cast<int>(dofs[i]);
        }
    }
    for (const auto& p : impl_->scalar.get_unit_support_points()) node_barycentrics_.push_back({1 - p[0] - p[1] - p[2], p[0], p[1], p[2]});
}

Discretization::~Discretization() = default;

int Discretization::dofs() const { return static_cast<int>(impl_->dofs.n_dofs()); }

int Discretization::nodes_per_cell() const { return static_cast<int>(node_barycentrics_.size()); }

std::vector<int> Discretization::edge_nodes(const std::array<int, 2>& ends) const {
    std::vector<int> nodes{ends[0], ends[1]};  // vertices are the first nodes
    for (int node = 4; node < nodes_per_cell(); ++node)
        if (node_barycentrics_[node][ends[0]] > 0 && node_barycentrics_[node][ends[1]] > 0) nodes.push_back(node);
    return nodes;
}

void Discretization::shape(const Point& unit, std::span<double> values, std::span<Point> gradients) const {
    const dealii::Point<3> point = to_deal_ii(unit);
    for (unsigned int node = 0; node < impl_->scalar.n_dofs_per_cell(); ++node) {
        values[node] = impl_->scalar.shape_value(node, point);
        const dealii::Tensor<1, 3> gradient = impl_->scalar.shape_grad(node, point);
        gradients[node] = {gradient[0], gradient[1], gradient[2]};
    }
}

Discretization::Quadrature Discretization::quadrature(int order) {
    if (order < 1 || order > 4) throw Error("the quadrature order must be 1 to 4");
    const dealii::QGaussSimplex<3> rule(order);
    Quadrature quadrature;
    for (const auto& point : rule.get_points()) quadrature.points.push_back({point[0], point[1], point[2]});
    quadrature.weights = rule.get_weights();
    return quadrature;
}

}  // namespace cleave::fem
