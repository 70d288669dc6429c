#pragma once

#include "solver/mesh/tet_mesh.hpp"
#include "solver/parallel/workers.hpp"
#include "solver/subdivision/buffer.hpp"
#include "solver/subdivision/canonical_mesh.hpp"
#include "solver/subdivision/child_writer.hpp"
#include "solver/subdivision/cut.hpp"
#include "solver/subdivision/cutting_plane.hpp"
#include "solver/subdivision/links.hpp"
#include "solver/subdivision/options.hpp"
#include "solver/subdivision/parent_layout.hpp"
#include "solver/subdivision/parent_plan.hpp"
#include "solver/subdivision/piece_tables.hpp"
#include "solver/subdivision/streamed_output.hpp"
#include "solver/subdivision/subdivided.hpp"
#include "solver/subdivision/tet_boxes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cleave::subdivision {

/// The tets that a cut may subdivide: all, or those with one label (a fragment's), or of these those of one region.
struct Among {
    const int* labels = nullptr;  ///< per original tet; none: all tets
    int label = 0;
    const int* regions = nullptr;  ///< per original tet; none: all regions
    int region = 0;
    bool has_all() const { return labels == nullptr && regions == nullptr; }
    bool has(int tet) const { return (labels == nullptr || labels[tet] == label) && (regions == nullptr || regions[tet] == region); }
};

/// The fast form of PlainSubdivision, equal to it to the bit. A cut goes in four steps: finding the parents (TetBoxes), giving each its
/// place among the children, planning (numbers of points, links), writing the children (child_writer). One thread plans and writes a few
/// parents at a time, several plan all and share out the writing. Original tets keep their numbers 0 .. n-1; children are numbered from n
/// on, cut by cut, parent by parent, and stand in arrays of their own, so that a cut costs what it cuts and not what the body has. A
/// child's neighbour is read from tables: vertices of each tet are taken in sorted order, hence the two tets at a face number its pieces
/// alike, and nothing is hashed or matched. Threads share out chunks of parents whose places in the output are known before: the same
/// bytes for any number of threads.
class SubdivisionEngine {
public:
    /// Set-up: sorts, numbers and links; costs more than many cuts. The mesh must have passed mesh::check.
    explicit SubdivisionEngine(const mesh::TetMesh& mesh, const Options& options = {});

    /// Subdivides all whole tets (of those given) that the cut passes. Throws std::invalid_argument for a bad cut.
    Counts cut(const Cut& cut, const Among& among = {});

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
    bool is_cut(int tet) const { return state(tet).cut >= 0; }
    int originals() const { return canonical_.tets(); }
    const CanonicalMesh& canonical() const { return canonical_; }
    /// Of a cut tet: how it was divided, and its first child (counted among the children).
    const PieceTable& pieces(int tet) const { return tables_[state(tet).layout]; }
    int first_child(int tet) const { return state(tet).first_half_face / 4 - canonical_.tets(); }
    /// +1 or -1: the side of its cut.
    int side(int child) const { return pieces(child_parents_[child]).side[child - first_child(child_parents_[child])]; }
    /// Tets divided by the last cut, ascending, and the first of its children.
    std::span<const int> last_parents() const { return {parents_.data() + first_parent_, parents_.size() - first_parent_}; }
    int first_new_child() const { return first_new_child_; }
    /// The original half face, in its tet's order of faces, that a child's outer half face (4 * (originals + child) + face) is a part of;
    /// -1 for one inside the parent.
    int original_half_face(int half_face) const;

    /// Extra links of all cuts so far, found anew at each call.
    void find_extra_links(Buffer<ExtraLink>& links) const;

    /// Everything as PlainSubdivision gives it (tets renumbered, arrays copied: not fast).
    Subdivided result() const;

private:
    struct State {
        int cut = -1;             ///< the cut that divided it, -1: whole
        int first_half_face = 0;  ///< of its children
        int place = 0;            ///< among the parents of that cut, from 1 on
        unsigned layout = 0;      ///< how it is divided: 2 * sign pattern + odd
    };
    const State& state(int tet) const { return states_[static_cast<std::size_t>(tet) + 1]; }
    void find_parents(const Cut& cut, const CuttingPlane& plane, const Among& among);
    void find_together(const Cut& cut, const CuttingPlane& plane, const Among& among);
    void find_in_boxes(std::size_t first, std::size_t last, const Cut& cut, const CuttingPlane& plane, const Among& among,
                       Buffer<std::uint64_t>& found) const;
    bool passes_disc(const Cut& cut, const CuttingPlane& plane, int tet) const;
    void place_parents();
    struct Planner;
    Planner planner();
    void divide_parents(const CuttingPlane& plane);
    void divide_alone(const CuttingPlane& plane);
    void divide_together(const CuttingPlane& plane);
    void plan_parents(std::size_t first, std::size_t last, Planner& planner);
    void join_earlier_base(const State& there, ParentPlan& plan);
    std::array<double, 3>* points_from_zero();
    ChildArrays children_from(int child);
    void write_parents(const ParentPlan* first, const ParentPlan* last, const CuttingPlane& plane, Buffer<LooseFace>& loose);
    bool streams(std::size_t parents) const { return parents >= static_cast<std::size_t>(std::max(options_.streamed_from, 0)); }
    void stream_parents(const ParentPlan* first, const ParentPlan* last, const CuttingPlane& plane, StreamedChildren& out,
                        Buffer<LooseFace>& loose);
    class Renumbering;
    void append_whole(int tet, const Renumbering& renumbering, Subdivided& out) const;
    void append_child(std::size_t child, const Renumbering& renumbering, Subdivided& out) const;
    Triangle triangle(const std::array<int, 4>& tet, int face) const;
    FaceSide face_side(int tet, int sorted_face) const;
    void link_loose_face(int tet, int face, Buffer<ExtraLink>& links) const;
    void link_loose_faces(std::size_t first, std::size_t last, Buffer<ExtraLink>& links) const;

    const PieceTable* tables_;
    const ParentLayout* layouts_;
    CanonicalMesh canonical_;
    TetBoxes boxes_;
    mesh::TetMesh original_;
    Options options_;
    LargeVector<State> states_;      ///< the first belongs to no tet, then per tet: see state()
    LargeVector<int> edge_point_;    ///< per edge: its last cut point; below the first one of the current cut: an earlier cut's
    Buffer<std::uint32_t> near_;     ///< boxes that the current cut may pass
    Buffer<std::uint64_t> found_;    ///< parents of the current cut: 32 * tet + layout, ascending
    Buffer<ParentPlan> plans_;       ///< of the parents that are divided at a time
    Buffer<std::array<int, 4>> face_points_;  ///< per parent of the current cut, by place: ParentPlan::face_point
    Buffer<int> parents_;            ///< of all cuts
    Buffer<LooseFace> loose_;        ///< of all cuts
    std::size_t first_parent_ = 0;   ///< of the current cut
    int first_new_child_ = 0;        ///< of the current cut
    std::vector<Buffer<LooseFace>> chunk_loose_;      ///< per chunk of parents, where several threads write
    std::vector<Buffer<std::uint64_t>> chunk_found_;  ///< per chunk of boxes, where several threads search
    parallel::Workers workers_;
    int cuts_ = 0;                   ///< so far; the current cut's number
    Counts counts_;
    Buffer<std::array<int, 4>> child_tets_, child_links_;
    Buffer<std::array<double, 3>> child_centroids_, points_;
    Buffer<double> child_volumes_;
    Buffer<int> child_parents_;
};

}  // namespace cleave::subdivision
