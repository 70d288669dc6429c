#pragma once

#include "solver/mesh/tet_mesh.hpp"
#include "solver/subdivision/buffer.hpp"
#include "solver/subdivision/canonical_mesh.hpp"
#include "solver/subdivision/cut.hpp"
#include "solver/subdivision/options.hpp"
#include "solver/subdivision/piece_tables.hpp"
#include "solver/subdivision/sparse_bits.hpp"
#include "solver/subdivision/subdivided.hpp"
#include "solver/subdivision/tet_boxes.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace cleave::subdivision {

/// A cut's plane as plain numbers.
struct SubdivisionPlane {
    std::array<double, 3> normal, centre;
    double tau;
    double distance(const Vector4& x) const {
        return (normal[0] * (x[0] - centre[0]) + normal[1] * (x[1] - centre[1])) + normal[2] * (x[2] - centre[2]);
    }
    /// vertex_distances of one vertex; x[3] is its shortest edge.
    double raised(const Vector4& x) const {
        const double d = distance(x), least = tau * x[3];
        const double size = d >= 0 ? d : -d;
        const double up = size > least ? size : least;
        return d >= 0 ? up : -up;
    }
};


/// The fast form of PlainSubdivision, equal to it to the bit. Original tets keep their numbers 0 .. n-1; children are numbered
/// from n on, cut by cut, parent by parent, and stand in arrays of their own, so that a cut costs what it cuts and not what the
/// body has. A child's neighbour is read from tables: vertices of each tet are taken in sorted order, hence the two tets at a
/// face number its pieces alike, and nothing is hashed or matched.
class SubdivisionEngine {
public:
    /// Set-up: sorts, numbers and links; costs more than many cuts. The mesh must have passed mesh::check.
    explicit SubdivisionEngine(const mesh::TetMesh& mesh, const Options& options = {});

    /// Subdivides all whole tets that the cut passes. Throws std::invalid_argument for a bad cut.
    Counts cut(const Cut& cut);

    /// Whole again; memory is kept.
    void reset();

    /// Children: vertices, and the half faces (4 * tet + face) behind their faces, -1 at the boundary and where extra links stand.
    const Buffer<std::array<int, 4>>& child_tets() const { return child_tets_; }
    const Buffer<std::array<int, 4>>& child_links() const { return child_links_; }
    const Buffer<std::array<double, 3>>& child_centroids() const { return child_centroids_; }  ///< m
    const Buffer<double>& child_volumes() const { return child_volumes_; }                      ///< m^3
    const Buffer<int>& child_parents() const { return child_parents_; }
    /// New points, numbered from the original vertices on, m.
    const Buffer<std::array<double, 3>>& points() const { return points_; }
    const Counts& counts() const { return counts_; }
    bool is_cut(int tet) const { return states_[tet].cut >= 0; }

    /// Extra links of all cuts so far, found anew at each call.
    void find_extra_links(std::vector<ExtraLink>& links) const;

    /// Everything as PlainSubdivision gives it (tets renumbered, arrays copied: not fast).
    Subdivided result() const;

private:
    struct State {
        int cut = -1;          ///< the cut that divided the tet, -1: whole
        int first_child = 0;   ///< among the children
        int variant = 0;       ///< 2 * plus mask + odd: names its piece table
    };
    const PieceTable& table(int tet) const { return (*tables_)[static_cast<std::size_t>(states_[tet].variant)]; }
    void find_parents(const Cut& cut, const SubdivisionPlane& plane);
    void scan_all(const Cut& cut, const SubdivisionPlane& plane);
    void scan_near(const Cut& cut, const SubdivisionPlane& plane);
    void add_parent(int tet, unsigned plus_mask);
    bool passes_disc(const Cut& cut, const SubdivisionPlane& plane, int tet) const;
    void mark_points();
    void number_points(const SubdivisionPlane& plane);
    void write_parent(const SubdivisionPlane& plane, std::size_t place, int centre);
    void write_children(const PieceTable& pieces, int tet, const double* corners, const int* numbers);
    void link_face(const PieceTable& pieces, int tet, int face);
    bool writes_face_point(int tet, int face) const;
    void set_point(int number, const Vector4& x);
    int half_face_key(int tet, int face) const;
    int child_half_face(int tet, std::uint8_t relative) const;

    std::array<double, 3> vertex(int number) const;
    struct Sides;
    void gather_sides(int key, Sides& sides) const;

    const std::array<PieceTable, 32>* tables_;
    CanonicalMesh canonical_;
    TetBoxes boxes_;                 ///< empty for small meshes
    mesh::TetMesh original_;
    Options options_;
    std::vector<State> states_;
    std::vector<int> edge_number_;   ///< per edge, of the current cut
    std::vector<int> base_number_;   ///< per face: its barycentre as an uncut face, -1: none yet
    std::vector<int> quad_number_;   ///< per face, of the current cut
    std::vector<std::uint8_t> plus_;  ///< per vertex: its side, of the current cut
    SparseBits edges_, faces_;       ///< with new points in the current cut
    SparseBits found_;               ///< parents of the current cut, before they are listed
    SparseBits loose_;               ///< original half faces (the smaller of the two) whose sides do not conform
    Buffer<int> parents_;            ///< of all cuts
    std::size_t first_parent_ = 0;   ///< of the current cut
    int first_point_ = 0;            ///< of the current cut
    int cuts_ = 0;
    Counts counts_;
    Buffer<std::array<int, 4>> child_tets_, child_links_;
    Buffer<std::array<double, 3>> child_centroids_, points_;
    Buffer<double> child_volumes_;
    Buffer<int> child_parents_;
};

}  // namespace cleave::subdivision
