#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace cleave::fracture {

/// A triangle between particles of two materials.
struct InterfaceFace {
    std::array<Eigen::Vector3d, 3> corner;  ///< m
    std::array<int, 2> particle;            ///< tets on its sides
    std::array<int, 2> material;            ///< of each side
};

/// Faces between tets of different material (index per tet, Solid::material), by ascending half face. For bodies cut since, call again with
/// their mesh.
std::vector<InterfaceFace> interface_faces(const mesh::TetMesh& mesh, const std::vector<int>& material);

/// Where a disc first meets the material's border: of the points of the faces' cuts with the disc the nearest to its centre.
struct InterfaceHit {
    Eigen::Vector3d position;  ///< m
    int to = 0;                ///< material beyond
};

/// One hit for each other material that the disc reaches out of material `from`, ascending by `to`.
std::vector<InterfaceHit> interface_hits(const std::vector<InterfaceFace>& faces, int from, const Eigen::Vector3d& centre,
                                         const Eigen::Vector3d& normal, double radius);

}  // namespace cleave::fracture
