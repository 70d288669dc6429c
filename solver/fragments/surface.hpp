#pragma once

#include "solver/fragments/fragmented_body.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace cleave::fragments {

/// One triangle of a fragment's surface.
struct SurfaceFace {
    std::array<int, 3> points;  ///< of Surface::points, counter-clockwise seen from outside
    int particle;               ///< whose face it is, or a part of
    bool crack;                 ///< made by a crack; false: the body's own surface
};

/// The surface of a fragment: closed, oriented outwards, in rest coordinates.
struct Surface {
    std::vector<Eigen::Vector3d> points;  ///< m
    std::vector<SurfaceFace> faces;
};

/// All faces of a fragment's particles behind which there is no linked particle. Where a face is partly linked (a non-conforming face
/// with some of its links removed) the overlaps with the lost partners are cut out of it. Points are shared between the
/// faces, and edges are divided at the points that lie on them, so that each edge has one partner of the other direction.
Surface surface(const FragmentedBody& body, const Fragment& fragment);

/// By the divergence theorem, sum of a . (b x c) / 6, m^3.
double enclosed_volume(const Surface& surface);

/// Edges (directed) without a partner of the other direction: 0 for a closed surface.
int open_edges(const Surface& surface);

}  // namespace cleave::fragments
