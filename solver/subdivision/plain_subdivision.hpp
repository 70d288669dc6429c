#pragma once

#include "solver/subdivision/cut.hpp"
#include "solver/subdivision/options.hpp"
#include "solver/subdivision/subdivided.hpp"
#include "solver/subdivision/templates.hpp"

#include <array>
#include <map>
#include <vector>

namespace cleave::subdivision {

/// Cuts tets along planes and discs (paper Sect. 5.2, Algorithm 2), each parent at most once: a tet that a later cut passes
/// again stays as the first left it. Written for clarity; the oracle of any faster form. O(n log n) per cut, deterministic.
class PlainSubdivision {
public:
    /// The mesh must have passed mesh::check. Throws std::invalid_argument for three tets at a face, or a bad tau (at the cut).
    explicit PlainSubdivision(mesh::TetMesh mesh, const Options& options = {});

    /// Subdivides all whole tets that the cut passes. Throws std::invalid_argument for a bad cut.
    Counts cut(const Cut& cut);

    /// The mesh as it stands, with all links.
    Subdivided result() const;

private:
    /// A tet about to be cut: its vertices sorted, where they stood, and its sign pattern.
    struct Parent {
        int tet;
        std::array<int, 4> sorted;    ///< vertex numbers, ascending
        std::array<int, 4> position;  ///< of sorted[i] in the tet
        bool odd;                     ///< the sorted order has the other orientation
        unsigned plus_mask;           ///< over sorted
    };
    struct Child {
        std::array<int, 4> vertices;
        std::array<std::int8_t, 4> parent_face;
        int parent;
        int cut;
        std::int8_t side;
        double volume;
    };
    /// Sorted vertices of an edge or face -> number of its point, for one cut.
    struct NewPoints {
        std::map<std::array<int, 2>, int> edges;
        std::map<std::array<int, 3>, int> quads;
    };

    std::vector<Parent> parents_of(const Cut& cut, const std::vector<double>& distances) const;
    std::array<int, 15> make_points(const Parent& parent, const std::vector<double>& distances, NewPoints& points);
    int edge_point_of(const Parent& parent, int edge, const std::vector<double>& distances, NewPoints& points);
    int quad_point_of(const Parent& parent, int face, const std::array<int, 15>& numbers, NewPoints& points);
    int base_point_of(const Parent& parent, int face);
    int centre_of(const CutTemplate& cut, const std::array<int, 15>& numbers);
    std::vector<double> volumes_of(const Parent& parent, const std::vector<double>& distances) const;
    void add_children(const Parent& parent, const std::array<int, 15>& numbers, const std::vector<double>& volumes);
    int add_vertex(const Eigen::Vector3d& position);

    mesh::TetMesh mesh_;                            ///< vertices grow; tets stay the original ones
    std::vector<double> shortest_edges_;            ///< of the original mesh
    Options options_;
    std::vector<bool> is_cut_;                      ///< per original tet
    std::map<std::array<int, 3>, int> barycentres_;  ///< of uncut faces, for all cuts: made once
    std::vector<Child> children_;
    Counts counts_;
    int cuts_ = 0;
};

/// PlainSubdivision in one call.
Subdivided subdivide(const mesh::TetMesh& mesh, const std::vector<Cut>& cuts, const Options& options = {});

}  // namespace cleave::subdivision
