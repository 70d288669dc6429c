#pragma once

#include "solver/subdivision/canonical_mesh.hpp"
#include "solver/subdivision/cutting_plane.hpp"
#include "solver/subdivision/parent_layout.hpp"
#include "solver/subdivision/parent_plan.hpp"

#include <array>

namespace cleave::subdivision {

/// Where a parent's children go: from its first child on.
struct ChildArrays {
    std::array<int, 4>*tets, *links;
    std::array<double, 3>* centroids;
    double* volumes;
    int* parents;
};

/// Writes the children of a parent and the points it makes, all from its corners. `vertices` by number; `points`: the place of the
/// point with number 0 (the vertices' numbers come before the new points'). `first_half_face`: of its first child.
void write_children(const CuttingPlane& plane, const ParentPlan& plan, const ParentLayout& layout, const Vector4* vertices,
                    int first_half_face, const ChildArrays& out, std::array<double, 3>* points);

}  // namespace cleave::subdivision
