#pragma once

#include "solver/subdivision/canonical_mesh.hpp"
#include "solver/subdivision/cutting_plane.hpp"
#include "solver/subdivision/parent_layout.hpp"
#include "solver/subdivision/parent_plan.hpp"

#include <array>

namespace cleave::subdivision {

/// What lies behind a parent's faces: half faces, or -1 at the boundary and where faces do not conform.
struct OuterLinks {
    static constexpr int none = -64;  ///< for `ring`: still below 0 at all of its half faces
    std::array<int, 4> ring;  ///< behind the first triangle of the quadrilateral's ring; the next three follow at 4, 8, 12
    std::array<int, 4> lone;  ///< behind the lone vertex's triangle
    std::array<int, 3> base;  ///< behind the pieces of a base
};

/// Where a parent's children go: from its first child on.
struct ChildArrays {
    std::array<int, 4>*tets, *links;
    std::array<double, 3>* centroids;
    double* volumes;
    int* parents;
};

/// Writes the children of a parent and the points it makes, all from its corners. `vertices` by number; `points`: the place of the
/// point with number 0 (the vertices' numbers come before the new points'). `first_half_face`: of its first child.
void write_children(const CuttingPlane& plane, const ParentPlan& plan, const ParentLayout& layout, const OuterLinks& outer,
                    const Vector4* vertices, int first_half_face, const ChildArrays& out, std::array<double, 3>* points);

}  // namespace cleave::subdivision
