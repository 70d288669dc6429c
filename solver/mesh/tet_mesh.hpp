#pragma once

#include <Eigen/Core>

#include <array>
#include <compare>
#include <map>
#include <string>
#include <vector>

namespace cleave::mesh {

/// A surface triangle that carries a tag (a physical surface of Gmsh), vertices as in the file.
struct SurfaceTriangle {
    std::array<int, 3> vertices;
    int id;
    friend bool operator==(const SurfaceTriangle&, const SurfaceTriangle&) = default;
};

/// A body cut into tetrahedra. A tet (a, b, c, d) is positive where (b-a) x (c-a) . (d-a) > 0.
struct TetMesh {
    std::vector<Eigen::Vector3d> vertices;   ///< m
    std::vector<std::array<int, 4>> tets;    ///< vertex numbers from 0
    std::vector<int> regions;                ///< per tet: the physical volume's tag, 0 without one
    std::vector<SurfaceTriangle> surface;    ///< triangles that carry a physical tag; may be empty
    std::map<int, std::string> region_names;   ///< physical volume tag -> name, where the file names it
    std::map<int, std::string> surface_names;  ///< physical surface tag -> name, where the file names it
};

/// Local vertices of face f of a tet, which lies opposite local vertex f; seen from outside, counter-clockwise.
inline constexpr std::array<std::array<int, 3>, 4> face_vertices{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// (b-a) x (c-a) . (d-a) / 6, m^3: positive for a tet of the right orientation.
double signed_volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d);

/// signed_volume of the mesh's tet, m^3.
double tet_volume(const TetMesh& mesh, int tet);

/// Mean of the four vertices, m.
Eigen::Vector3d tet_centroid(const TetMesh& mesh, int tet);

/// Sum of the tet volumes, m^3.
double total_volume(const TetMesh& mesh);

/// The angle between two faces of a tet, the smallest of its six, radians (0 to 1.2310; a flat tet has 0).
double smallest_dihedral_angle(const TetMesh& mesh, int tet);

/// The vertex numbers of a tet's face, in the order of face_vertices.
std::array<int, 3> face_of(const std::array<int, 4>& tet, int face);

/// A face by its sorted vertices, and the half face 4 * tet + face it belongs to.
struct SortedFace {
    std::array<int, 3> vertices;
    int half_face;
    friend auto operator<=>(const SortedFace&, const SortedFace&) = default;
};

/// All 4 faces of all tets, sorted by vertices, then half face: the faces that tets share stand together.
std::vector<SortedFace> sorted_faces(const TetMesh& mesh);

/// Who lies behind each face: opposite[4 * tet + face] = 4 * other_tet + other_face, -1 where nobody does (the boundary).
/// Symmetric: opposite[opposite[h]] == h. Faces are numbered by the vertex they lie opposite to.
struct HalfFaceLinks {
    std::vector<int> opposite;  ///< 4 per tet
};

/// Pairs faces with equal vertices. O(n log n), deterministic.
/// Throws std::invalid_argument where three tets share a face (check() reports that to a user with the file's name).
HalfFaceLinks link_half_faces(const TetMesh& mesh);

}  // namespace cleave::mesh
