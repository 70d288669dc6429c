#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <Eigen/Core>

#include <vector>

namespace cleave::elasticity {

/// A face of the mesh, stored once.
struct Face {
    Eigen::Vector3d centroid;  ///< m
    Eigen::Vector3d area;      ///< m^2, normal out of `inside` times the area
    int inside;                ///< tet
    int outside;               ///< the tet behind it, -1 at the boundary (the lip of a crack is one)

    bool is_boundary() const { return outside < 0; }
};

struct FaceSet {
    std::vector<Face> faces;         ///< by ascending half face of `inside`, which has the lower number of the two
    std::vector<int> of_half_face;   ///< 4 per tet: index into faces

    int size() const { return static_cast<int>(faces.size()); }
};

/// All faces of a mesh. The order depends on the tets only, not on where the vertices are.
FaceSet collect_faces(const mesh::TetMesh& mesh);

/// Surface id of every face, -1 where no tagged triangle has its vertices. Tagged triangles inside the body are left out.
std::vector<int> surface_ids(const mesh::TetMesh& mesh, const FaceSet& faces);

/// Number of the connected piece (by shared faces) of every tet, from 0 in the order of their first tets.
std::vector<int> connected_pieces(const FaceSet& faces, int tets);

}  // namespace cleave::elasticity
