#pragma once

#include <Eigen/Core>

#include <vector>

namespace cleave::mesh {

/// "We pre-process the initial object in layered structures due to the formation of anisotropic materials" (Sect. 5.1): planes
/// normal to `normal` cut the body, from its lowest point along the normal, every `thickness`; tets conform to the planes. Layer k
/// (from 1) becomes region k, "layer k", with the material frame turned by angles[(k-1) mod count] about `normal`. A last layer
/// thinner than a quarter of `thickness` joins the one below.
struct Layers {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double thickness = 0;         ///< m
    std::vector<double> angles;   ///< radians; at least one
};

}  // namespace cleave::mesh
