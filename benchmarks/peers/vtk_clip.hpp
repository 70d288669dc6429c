#pragma once

#include "solver/mesh/tet_mesh.hpp"
#include "solver/subdivision/cut.hpp"

#include <cstddef>
#include <memory>

namespace cleave::benchmarks {

/// VTK's vtkTableBasedClipDataSet on a tet mesh, both sides of a plane kept.
class VtkClip {
public:
    /// Copies the mesh into a vtkUnstructuredGrid.
    explicit VtkClip(const mesh::TetMesh& mesh);
    ~VtkClip();

    /// Clips anew by the cut's plane (its radius is not looked at).
    void clip(const subdivision::Cut& cut);

    /// Cells of both sides after the last clip.
    std::size_t cells() const;

private:
    struct Filter;
    std::unique_ptr<Filter> filter_;
};

}  // namespace cleave::benchmarks
