#pragma once

#include "reference_fem/discretization.hpp"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/grid/tria.h>

namespace cleave::fem {

/// The mesh as deal.II's; active cells and their vertices are numbered as in the mesh.
void fill(dealii::Triangulation<3>& triangulation, const Mesh& mesh);

/// The deal.II objects; order matters, each refers to those above it.
struct Discretization::Impl {
    explicit Impl(int degree) : scalar(degree), element(scalar, 3), mapping(dealii::FE_SimplexP<3>(1)) {}

    dealii::Triangulation<3> triangulation;
    dealii::FE_SimplexP<3> scalar;
    dealii::FESystem<3> element;
    dealii::MappingFE<3> mapping;  // straight-sided: the geometry of the .msh
    dealii::DoFHandler<3> dofs;
};

}  // namespace cleave::fem
