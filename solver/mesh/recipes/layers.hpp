#pragma once

#include <Eigen/Core>

#include <vector>

namespace cleave::mesh {

/// "We pre-process the initial object in layered structures due to the formation of anisotropic materials" (Sect. 5.1): the planes
/// normal . x = k thickness (k whole) cut the body, and tets conform to them. The layers, counted along the normal, become the
/// regions 1 "layer 1", 2 "layer 2", ...; layer k has the material frame turned by angles[(k - 1) mod count] about `normal`.
struct Layers {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of any length
    double thickness = 0;                               ///< m
    std::vector<double> angles;                         ///< radians; at least one
    friend bool operator==(const Layers&, const Layers&) = default;
};

}  // namespace cleave::mesh
