#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace cleave::subdivision {

/// How a tet is cut (paper Fig. 4; physics: Sect. 5.2). Everything is told in the parent's SORTED vertices s0 < s1 < s2 < s3
/// (global numbers), so that the two tets at a face number its pieces alike.

/// A point of the parent, as a code: 0..3 the vertices, 4..9 the cut points of the edges (01, 02, 03, 12, 13, 23), 10..13 the
/// barycentre on the face opposite vertex 0..3 (of the face where it is uncut, of its quadrilateral where it is cut), 14 the
/// mean of the four cut points of a 2-2 tet.
using PointCode = std::uint8_t;
inline constexpr PointCode first_edge_code = 4, first_face_code = 10, centre_code = 14;
inline constexpr std::array<std::array<int, 2>, 6> edge_ends{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// The code of the cut point between local vertices i and j.
PointCode edge_code(int i, int j);

/// Bit f is set where the point lies on the face opposite local vertex f.
unsigned faces_of(PointCode code);

struct ChildTemplate {
    std::array<PointCode, 4> points;  ///< a positive tet where the sorted parent is positive
    int side;                         ///< +1 or -1: the side of the cut
};

struct CutTemplate {
    std::vector<ChildTemplate> children;  ///< 14 (3-1), 20 (2-2), none (no cut)
    unsigned edges = 0;                   ///< bit e: edge e is cut
    unsigned quad_faces = 0;              ///< bit f: face f is cut (and has a quadrilateral with a barycentre)
    int base_face = -1;                   ///< 3-1: the uncut face, which has a barycentre; -1 else
    bool centre = false;                  ///< 2-2: has the mean of its cut points
    /// The sorted vertices by their part in the cut: 3-1: the lone one, then the others, ascending; 2-2: the two '+', then the two
    /// '-', both ascending. All 3-1 templates are one, and all 2-2 ones, when told in these.
    std::array<int, 4> roles{};
    /// The points that a cut makes, in the order in which a parent makes those that no parent before it made: cut points (3-1: of
    /// the lone vertex and each other; 2-2: ++ by --), barycentres of quadrilaterals (in the order of the children), then that of
    /// the base or the mean of the cut points.
    std::vector<PointCode> points;
};

/// The template of a sign pattern: bit i is set where sorted vertex i is on the '+' side; 0 and 15 have no children.
/// 3-1 -> (apex, P1, P2, P3), (P1, P2, P3, c), and the three quadrilaterals P_i P_j b_j b_i in four about their barycentre, with
/// apex c. 2-2 -> per side two end tets and two quadrilaterals in four, with apex q.
const CutTemplate& cut_template(unsigned plus_mask);

}  // namespace cleave::subdivision
