#pragma once

#include "solver/subdivision/buffer.hpp"
#include "solver/subdivision/canonical_mesh.hpp"
#include "solver/subdivision/cutting_plane.hpp"
#include "solver/subdivision/parent_layout.hpp"
#include "solver/subdivision/parent_plan.hpp"

#include <array>

namespace cleave::subdivision {

/// Where children go: from the first one of the first plan on.
struct ChildArrays {
    std::array<int, 4>*tets, *links;
    std::array<double, 3>* centroids;
    double* volumes;
    int* parents;
    std::array<double, 3>* points;  ///< the place of the point with number 0 (new points are numbered after the vertices)
};

/// Writes the children of parents in a row, the points they make, and lists the faces that do not conform. `vertices` by number. Returns the number of
/// children.
std::size_t write_children(const CuttingPlane& plane, const ParentPlan* first, const ParentPlan* last, const ParentLayout* layouts,
                           const Vector4* vertices, ChildArrays out, Buffer<LooseFace>& loose);

}  // namespace cleave::subdivision
