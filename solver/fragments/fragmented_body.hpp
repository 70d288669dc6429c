#pragma once

#include "solver/fragments/crack.hpp"
#include "solver/fragments/link_table.hpp"
#include "solver/fragments/linked_sets.hpp"
#include "solver/mesh/tet_mesh.hpp"
#include "solver/subdivision/options.hpp"
#include "solver/subdivision/subdivided.hpp"
#include "solver/subdivision/subdivision_engine.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace cleave::fragments {

/// A connected component of links. Numbers are never used twice: a fragment that falls apart is retired, and its pieces get new
/// numbers (ascending by their smallest particle).
struct Fragment {
    int origin = -1;              ///< the fragment it broke off; -1: of the first body
    bool retired = false;         ///< it fell apart; its particles moved on
    std::vector<int> particles;   ///< ascending
};

/// What one crack did.
struct CrackOutcome {
    subdivision::Counts counts;      ///< parents subdivided by this crack (counts.uncut: whole parents left in the body)
    int removed_links = 0;           ///< that the disc intersects
    int isolated = 0;                ///< particles inside r_inner
    std::vector<int> new_fragments;  ///< empty where the fragment stayed in one piece
};

/// A body of tets, its cracks and its fragments, all in rest coordinates. Particles are tets: the original ones keep their numbers
/// 0 .. originals()-1, children are numbered from there on, crack by crack; a subdivided original is no particle any more.
/// Later cracks that cross children remove links as the basic method does. Deterministic.
class FragmentedBody {
public:
    /// The mesh must have passed mesh::check. Components of the mesh are the first fragments (0, 1, ...).
    explicit FragmentedBody(const mesh::TetMesh& mesh, Scheme scheme = Scheme::adaptive, const subdivision::Options& options = {});

    /// Opens a crack in one fragment; the others stay as they are, even where the disc reaches them (they may have moved away).
    /// A link is intersected where its two particles lie on different sides (a child of this cut: its side of the cut; else the
    /// centroid's) and the point where the line between the centroids meets the plane lies inside the disc.
    /// Throws std::invalid_argument for a bad disc, a negative or non-finite inner radius, a fragment that does not exist or is retired.
    CrackOutcome crack(const Crack& crack, int fragment);

    /// The two halves of crack(), for who wants their times apart (Table 2). The paper's "particle subdivision": divides the tets that
    /// the disc passes and links their children. Nothing in the basic scheme.
    subdivision::Counts subdivide(const Crack& crack, int fragment);
    /// The paper's "crack generation": removes links and finds the fragments. After subdivide() with the same arguments.
    CrackOutcome open(const Crack& crack, int fragment);

    /// Whole again; memory is kept.
    void reset();

    int originals() const { return static_cast<int>(mesh_.tets.size()); }
    /// Numbers of particles ever used: originals and children.
    int particle_numbers() const;
    bool is_particle(int number) const;                       ///< false for a subdivided original
    std::array<int, 4> vertices(int particle) const;          ///< positive orientation
    Eigen::Vector3d point(int vertex) const;                  ///< m, original vertices and those made by cuts
    double volume(int particle) const;                        ///< m^3
    Eigen::Vector3d centroid(int particle) const;             ///< m
    int parent(int particle) const;                           ///< its original tet; an original is its own
    int region(int particle) const;                           ///< the parent's
    int fragment_of(int particle) const { return fragment_of_[static_cast<std::size_t>(particle)]; }

    int fragments() const { return static_cast<int>(fragments_.size()); }  ///< retired ones included
    const Fragment& fragment(int number) const { return fragments_.at(static_cast<std::size_t>(number)); }
    std::vector<int> current_fragments() const;               ///< not retired, ascending

    const mesh::TetMesh& original() const { return mesh_; }
    const LinkTable& links() const { return links_; }
    Scheme scheme() const { return scheme_; }
    const subdivision::SubdivisionEngine& engine() const { return engine_; }

private:
    Crack valid(const Crack& crack, int fragment) const;
    void find_first_fragments();
    void unite(const std::vector<int>& particles);
    struct Row {
        std::size_t first, last;  ///< among the particles
        int fragment;
    };
    std::vector<Row> number_sets(const std::vector<int>& particles);
    std::vector<int> split(int fragment, std::vector<int> particles);

    mesh::TetMesh mesh_;
    Scheme scheme_;
    subdivision::SubdivisionEngine engine_;  ///< cuts nothing in the basic scheme
    LinkTable links_;
    std::vector<Fragment> fragments_;
    subdivision::LargeVector<int> fragment_of_;  ///< per particle number; -1: subdivided
    LinkedSets sets_;
};

/// What every particle of a fragment takes from its parent (density, velocity, smoothing tensor, material, ...): of_original[parent(i)].
template <class Value>
std::vector<Value> inherited(const FragmentedBody& body, const Fragment& fragment, const std::vector<Value>& of_original) {
    std::vector<Value> values;
    values.reserve(fragment.particles.size());
    for (const int particle : fragment.particles) values.push_back(of_original[static_cast<std::size_t>(body.parent(particle))]);
    return values;
}

}  // namespace cleave::fragments
