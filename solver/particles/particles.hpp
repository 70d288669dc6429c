#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <Eigen/Core>

#include <vector>

namespace cleave::particles {

/// Default support radius in local spacings: about 60 neighbours inside a body.
inline constexpr double default_support_ratio = 2.5;

/// The physical particles of a body (Sect. 5.1), one per tetrahedron; every array has one entry per particle.
struct Particles {
    std::vector<Eigen::Vector3d> position;  ///< m, the tet's centroid
    std::vector<double> volume;             ///< m^3, the tet's
    std::vector<double> radius;             ///< m, (3 V / 4 pi)^(1/3)
    std::vector<double> spacing;            ///< m, local particle spacing s_i
    std::vector<double> support_radius;     ///< m, h_i = k s_i: det(tensor) = h^-3
    std::vector<Eigen::Matrix3d> tensor;    ///< 1/m, smoothing tensor G_i
    std::vector<int> region;                ///< the tet's region tag

    int size() const { return static_cast<int>(position.size()); }
};

/// Particles of a mesh with isotropic kernels h_i = support_ratio * s_i. s_i^3 is the mean over the tet's four vertices of the mean
/// volume of the tets around the vertex: the mesh's own neighbours smooth it, so that one sliver does not shrink a support.
/// Region 0 where the mesh has none. Throws std::invalid_argument where a tet's volume is not positive.
Particles from_mesh(const mesh::TetMesh& mesh, double support_ratio = default_support_ratio);

/// Particles at given places with given volumes (m^3 > 0) and one spacing (m), isotropic kernels, region 0.
Particles from_points(const std::vector<Eigen::Vector3d>& position, const std::vector<double>& volume, double spacing,
                      double support_ratio = default_support_ratio);

}  // namespace cleave::particles
