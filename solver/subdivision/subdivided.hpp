#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <cstdint>
#include <vector>

namespace cleave::subdivision {

/// Two half faces of the result that overlap without being equal (4 * tet + face, first < second), and by how much.
struct ExtraLink {
    int first;
    int second;
    double area;  ///< of the overlap, m^2
    friend bool operator==(const ExtraLink&, const ExtraLink&) = default;
};

/// Work done: particles after = uncut + 14 three_one + 20 two_two.
struct Counts {
    int uncut = 0;      ///< parents left whole
    int three_one = 0;  ///< parents cut with one vertex on one side
    int two_two = 0;    ///< parents cut with two vertices on each side
    int after() const { return uncut + 14 * three_one + 20 * two_two; }
    friend bool operator==(const Counts&, const Counts&) = default;
};

/// A subdivided mesh. Tets: first the parents left whole, in their order; then the children, cut by cut, parent by parent.
/// Vertices: first those of the original mesh; then, cut by cut, parent by parent, those of its points that no parent before it
/// made, in the order of CutTemplate::points.
struct Subdivided {
    mesh::TetMesh mesh;
    std::vector<int> parent;                ///< per tet: its tet in the original mesh
    std::vector<int> cut;                   ///< per tet: the cut that made it (0, 1, ...), -1 for a whole parent
    std::vector<std::int8_t> side;          ///< per tet: +1 or -1, its side of that cut; 0 for a whole parent
    std::vector<double> volume;             ///< per tet, m^3
    std::vector<Eigen::Vector3d> centroid;  ///< per tet, m
    std::vector<std::int8_t> parent_face;   ///< per half face: the parent's face (0..3) it is a part of, -1 inside the parent
    mesh::HalfFaceLinks links;              ///< pairs of equal faces; -1 at the boundary and where extra links stand
    std::vector<ExtraLink> extra_links;     ///< pairs that share a part of a face; in the order of links.hpp
    Counts counts;
};

}  // namespace cleave::subdivision
