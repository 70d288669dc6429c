// The VTU file read by VTK itself, which knows nothing of ours: counts, and the displacement inside cells by VTK's own shape functions.
// Built with CLEAVE_PEERS only (libvtk9-dev, 1 GB).

#include "reference_fem/elasticity.hpp"
#include "reference_fem/test/materials.hpp"
#include "reference_fem/test/msh_text.hpp"
#include "reference_fem/vtu.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>

namespace cleave::fem::testing {
namespace {

class VtuByVtk : public ::testing::TestWithParam<int> {};

TEST_P(VtuByVtk, InterpolatesAsTheSolutionDoes) {
    Problem problem;
    problem.mesh_file = write_box("vtk_read.msh", {});
    problem.regions = {{.id = 1, .stiffness = triclinic()}};
    problem.displacements = {{1, {true, true, true}, [](const Point&) { return Point{}; }}};
    problem.tractions = {{.surface = 2, .value = [](const Point&) { return Point{1e6, -2e5, 3e5}; }}};
    const Solution solution = solve(problem, {.degree = GetParam()});
    const std::string file = write_temporary("vtk_read.vtu", vtu_text(solution));

    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkUnstructuredGrid* grid = reader->GetOutput();
    ASSERT_EQ(grid->GetNumberOfCells(), solution.record().cells);
    ASSERT_EQ(3 * grid->GetNumberOfPoints(), solution.record().dofs);
    vtkDataArray* displacement = grid->GetPointData()->GetArray("displacement");
    ASSERT_TRUE(displacement && grid->GetCellData()->GetArray("stress"));
    EXPECT_EQ(grid->GetCellData()->GetArray("stress")->GetNumberOfComponents(), 6);
    double largest = 0, apart = 0, off_node = 0;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) {
        vtkCell* cell = grid->GetCell(i);
        const double place[3] = {0.2, 0.15, 0.4};  // no symmetry that would hide nodes in another order
        double weights[10], x[3];
        int part = 0;
        cell->EvaluateLocation(part, place, x, weights);
        const Point u = solution.at({x[0], x[1], x[2]}).displacement;
        for (int k = 0; k < 3; ++k) {
            double sum = 0, first = displacement->GetComponent(cell->GetPointId(0), k);
            for (int node = 0; node < cell->GetNumberOfPoints(); ++node) sum += weights[node] * displacement->GetComponent(cell->GetPointId(node), k);
            largest = std::max(largest, std::abs(u[k]));
            apart = std::max(apart, std::abs(sum - u[k]));
            off_node = std::max(off_node, std::abs(first - u[k]));
        }
    }
    EXPECT_LT(apart, 1e-12 * largest);
    EXPECT_GT(off_node, 1e-3 * largest) << "twin: the same comparison at another place must fail";
}

INSTANTIATE_TEST_SUITE_P(Degrees, VtuByVtk, ::testing::Values(1, 2));

}  // namespace
}  // namespace cleave::fem::testing
