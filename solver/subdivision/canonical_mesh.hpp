#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace cleave::subdivision {

/// Four doubles in one register: x, y, z and something of the user's.
using Vector4 __attribute__((vector_size(32))) = double;

/// What the fast form knows about a mesh once and for all: vertices of each tet sorted by number, neighbours, edges and faces
/// numbered in the order of their sorted vertices. O(n) apart from sorting short lists per vertex.
struct CanonicalMesh {
    explicit CanonicalMesh(const mesh::TetMesh& mesh);

    int tets() const { return static_cast<int>(sorted.size()); }
    int edges() const { return static_cast<int>(edge_ends.size()); }

    std::vector<Vector4> vertices;                     ///< x, y, z, shortest incident edge, m
    std::vector<std::array<int, 4>> sorted;            ///< per tet: vertices ascending
    std::vector<std::array<std::uint8_t, 4>> position; ///< per tet: where sorted vertex i stands in the tet
    std::vector<std::uint8_t> odd;                     ///< per tet: the sorted order has the other orientation
    std::vector<std::array<int, 4>> opposite;          ///< per tet and face (opposite sorted vertex f): 4 * tet + face, or -1
    std::vector<std::array<int, 6>> edge;              ///< per tet: numbers of its edges, in the order of edge_ends of a tet
    std::vector<std::array<int, 4>> face;              ///< per tet: numbers of its faces
    std::vector<std::array<int, 2>> edge_ends;         ///< per edge: its vertices, ascending; edges in this order
    int faces = 0;                                     ///< number of faces
};

}  // namespace cleave::subdivision
