#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace cleave::fracture {

/// A triangle between particles of two materials.
struct InterfaceFace {
    std::array<Eigen::Vector3d, 3> corner;  ///< m; (b - a) x (c - a) points from the first material into the second
    std::array<int, 2> particle;            ///< tets on its sides
    std::array<int, 2> material;            ///< theirs
};

/// Faces between linked tets of different material (an index per tet, as Solid::material), by ascending half face. To be made anew for
/// the mesh of a cut body.
std::vector<InterfaceFace> interface_faces(const mesh::TetMesh& mesh, const std::vector<int>& material);

/// Where a crack first meets another material.
struct InterfaceHit {
    Eigen::Vector3d position;  ///< m: of all cuts of the disc with faces to that material the point nearest to the disc's centre
    Eigen::Vector3d normal;    ///< unit, of the interface there (the mean of the faces that meet in the point), into the other material
    int to = 0;                ///< the other material
};

/// One hit for each material that a disc reaches out of material `from`, ascending by `to`. normal: unit; radius in m. Depends on the places
/// of the faces only, not on their order.
std::vector<InterfaceHit> interface_hits(const std::vector<InterfaceFace>& faces, int from, const Eigen::Vector3d& centre,
                                         const Eigen::Vector3d& normal, double radius);

}  // namespace cleave::fracture
