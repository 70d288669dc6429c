#pragma once

#include "solver/mesh/tet_mesh.hpp"
#include "solver/subdivision/cut.hpp"
#include "solver/subdivision/huge_pages.hpp"

#include <array>
#include <string>

namespace cleave::benchmarks {

/// A body and the plane that cuts it.
struct SubdivisionCase {
    std::string name;
    mesh::TetMesh mesh;
    subdivision::Cut cut;
};

/// The pot of 6,163 tets cut by a plane that holds its axis, tilted by nothing: the straight break in two halves. The plane was
/// not chosen for a count: any count of particles is 13 n31 + 19 n22 above the first for some cut and proves nothing.
SubdivisionCase pot_case();

/// A cube of 6 cells^3 tets (Kuhn's triangulation, inner vertices shaken, numbered along a Morton curve) and a plane askew through
/// its middle.
SubdivisionCase cube_case(int cells);

/// A disc of radius 2.2 cells at the cube's middle, at the same place of a cell: the same crack in cubes of any number of cells.
subdivision::Cut fixed_disc_in(int cells);

/// What a subdivision of this size writes, and nothing else: connectivity (16 bytes a child), links (16), centroid (24), volume
/// (8), parent (4), child by child as a subdivision does, and 24 bytes a new point, into arrays on huge pages as the engine's. The floor
/// under a subdivision by ordinary stores.
class PureStores {
public:
    PureStores(int children, int points);
    /// Writes every byte once.
    void run();
    /// The same by stores past the caches, array by array in chunks: the fastest way to memory, of use only to who has whole lines to write.
    void run_past_caches();
    std::size_t bytes() const;

private:
    subdivision::LargeVector<std::array<int, 4>> tets_, links_;
    subdivision::LargeVector<std::array<double, 3>> centroids_, points_;
    subdivision::LargeVector<double> volumes_;
    subdivision::LargeVector<int> parents_;
    int turn_ = 0;
};

}  // namespace cleave::benchmarks
