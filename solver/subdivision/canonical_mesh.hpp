#pragma once

#include "solver/mesh/tet_mesh.hpp"
#include "solver/subdivision/huge_pages.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace cleave::subdivision {

/// Four doubles in one register: x, y, z and something of the user's.
using Vector4 __attribute__((vector_size(32))) = double;

/// What the fast form knows about a mesh once and for all: vertices of each tet sorted by number, neighbours, numbers
/// for the edges (those of one lower vertex together). O(n): nothing but the four vertices of a tet is sorted.
struct CanonicalMesh {
    explicit CanonicalMesh(const mesh::TetMesh& mesh);

    int tets() const { return static_cast<int>(records.size()); }

    /// One tet, all that a cut asks of it in one line of memory.
    struct alignas(64) Record {
        std::array<int, 4> sorted;            ///< vertices ascending
        std::array<int, 4> opposite;          ///< behind the face opposite sorted vertex f: 4 * tet + face, or -1
        std::array<int, 6> edge;              ///< numbers of its edges, in the order of edge_ends of a tet
        std::array<std::uint8_t, 4> position; ///< where sorted vertex i stands in the tet
        std::uint8_t odd;                     ///< the sorted order has the other orientation
        std::uint8_t behind;                  ///< see position_behind
        /// Where the vertex opposite the face behind sorted face f stands in its tet: `position` of that tet, packed into two bits.
        int position_behind(int f) const { return behind >> 2 * f & 3; }
    };

    LargeVector<Vector4> vertices;                    ///< x, y, z, shortest incident edge, m
    LargeVector<Record> records;                      ///< per tet
    int edges = 0;                                    ///< number of edges
};

}  // namespace cleave::subdivision
