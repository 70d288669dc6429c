#include "benchmarks/peers/vtk_clip.hpp"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkTableBasedClipDataSet.h>
#include <vtkUnstructuredGrid.h>

namespace cleave::benchmarks {

struct VtkClip::Filter {
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkPlane> plane;
    vtkNew<vtkTableBasedClipDataSet> clip;
};

VtkClip::VtkClip(const mesh::TetMesh& mesh) : filter_(std::make_unique<Filter>()) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices.size()));
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) points->SetPoint(static_cast<vtkIdType>(v), mesh.vertices[v].data());
    vtkNew<vtkCellArray> cells;
    cells->AllocateExact(static_cast<vtkIdType>(mesh.tets.size()), static_cast<vtkIdType>(4 * mesh.tets.size()));
    for (const auto& tet : mesh.tets) cells->InsertNextCell({tet[0], tet[1], tet[2], tet[3]});
    filter_->grid->SetPoints(points);
    filter_->grid->SetCells(VTK_TETRA, cells);
    filter_->clip->SetInputData(filter_->grid);
    filter_->clip->SetClipFunction(filter_->plane);
    filter_->clip->GenerateClippedOutputOn();
}

VtkClip::~VtkClip() = default;

void VtkClip::clip(const subdivision::Cut& cut) {
    filter_->plane->SetOrigin(cut.centre.data());
    filter_->plane->SetNormal(cut.normal[0], cut.normal[1], cut.normal[2]);
    filter_->clip->Modified();
    filter_->clip->Update();
}

std::size_t VtkClip::cells() const {
    return static_cast<std::size_t>(filter_->clip->GetOutput()->GetNumberOfCells() + filter_->clip->GetClippedOutput()->GetNumberOfCells());
}

}  // namespace cleave::benchmarks
