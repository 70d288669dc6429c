#pragma once

#include "solver/mesh/tet_mesh.hpp"
#include "solver/subdivision/subdivided.hpp"
#include "solver/subdivision/triangle_overlap.hpp"

#include <array>
#include <vector>

namespace cleave::subdivision {

/// Finds who touches whom in a subdivided mesh (mesh, parent and parent_face must be filled) and fills links and extra_links.
/// Equal faces are linked. What is left on the two sides of an original face does not conform: by number of triangles 1-3
/// (paper Fig. 5a), 3-5 (Fig. 5c), and, omitted by the paper, 1-5 (at a disc's edge, or where the neighbour was cut before)
/// and 5-5 (cut by different planes); those are linked by the area of their overlap. Overlaps under 1e-14 of the original
/// face are rounding (triangles that share an edge) and no links.
/// Order of the extra links: each original face stands with that of its two tets that was cut later (by cut, then by number; a
/// whole tet comes before all), faces of one tet by the number of the vertex they lie opposite to; within a face by the pieces on
/// the side of the tet with the smaller number, then by those on the other side.
void find_links(const mesh::TetMesh& original, Subdivided& subdivided);

/// The pieces of an original face on one of its sides: half faces of the result, ascending, and their corners.
struct FaceSide {
    int count = 0;
    std::array<int, 5> half_faces;
    std::array<Triangle, 5> triangles;
    void add(int half_face, const Triangle& triangle) {
        half_faces[count] = half_face;
        triangles[count++] = triangle;
    }
};

/// Appends the extra links between the two sides of a face that does not conform, low by low, high by high. `low` is the side
/// of the smaller original half face, `face` the whole face, its corners in the order of their numbers.
void link_pieces(const FaceSide& low, const FaceSide& high, const Triangle& face, std::vector<ExtraLink>& links);

/// What a subdivided mesh breaks: worst figures over all half faces.
struct Audit {
    double worst_area_error = 0;  ///< | own area - area of all partners | / own area, where not on the body's boundary
    int asymmetric = 0;           ///< links whose partner does not link back, or whose faces are not equal
    int unpaired = 0;             ///< half faces inside the body without any partner
    int paired_boundary = 0;      ///< half faces on the body's boundary with a partner
    double smallest_share = 1;    ///< smallest child volume / volume of its parent
    double volume_error = 0;      ///< worst | sum of the children - parent | / (longest edge of the parent)^3
    double stated_volume_error = 0;  ///< worst | `volume` of a tet - that of its corners | / (longest edge of the parent)^3
};

/// Checks links, areas and volumes against the original mesh, by the positions of the vertices; parent and parent_face are only
/// trusted for what lies on the body's boundary.
Audit audit(const mesh::TetMesh& original, const Subdivided& subdivided);

}  // namespace cleave::subdivision
