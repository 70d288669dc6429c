#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <Eigen/Core>

#include <vector>

namespace cleave::mesh {

/// Numbers of the points along a Morton (z-order) curve through their bounding box, 21 bits an axis; ties by number.
std::vector<int> morton_order(const std::vector<Eigen::Vector3d>& points);

/// The same, coarser and faster: 10 bits an axis. An order along the finer curve is one along this curve.
std::vector<int> coarse_morton_order(const std::vector<Eigen::Vector3d>& points);

/// The same body with tets and vertices numbered along Morton curves: neighbours in space become neighbours in memory. Unused
/// vertices stay. The surface triangles keep their order.
TetMesh in_morton_order(const TetMesh& mesh);

}  // namespace cleave::mesh
