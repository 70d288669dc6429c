#pragma once

#include "solver/elasticity/conforming_box_tree.hpp"
#include "solver/elasticity/conforming_faces.hpp"

#include <array>
#include <vector>

namespace cleave::elasticity {

/// The faces nobody sees through: boundary faces, lips of cracks, interfaces between materials.
class Walls {
public:
    /// `opaque[f]` marks the faces that are walls.
    Walls(const mesh::TetMesh& mesh, const FaceSet& faces, const std::vector<char>& opaque);

    /// Walls whose box touches this box, ascending.
    std::vector<int> near(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const;

    /// True where the segment crosses none of these walls. A wall that contains `eye` does not block: the side of a wall the eye looks
    /// to is the caller's to decide. Walls count as larger by 1e-6 of their size: no slit between two of them, and a segment
    /// that meets an edge exactly (on symmetric meshes) is blocked, however it is rounded.
    bool visible(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, const std::vector<int>& walls) const;

private:
    bool blocks(const std::array<Eigen::Vector3d, 3>& wall, const Eigen::Vector3d& eye, const Eigen::Vector3d& target) const;

    std::vector<std::array<Eigen::Vector3d, 3>> triangles_;
    BoxTree tree_;
};

}  // namespace cleave::elasticity
