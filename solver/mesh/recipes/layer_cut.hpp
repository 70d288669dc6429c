#pragma once

#include "solver/mesh/recipes/layers.hpp"
#include "solver/mesh/recipes/occ_body.hpp"

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

namespace cleave::mesh {

/// Cuts the volumes of the current Gmsh model by the layers' planes: one region per layer, in place of the given ones. Throws MeshingError for
/// more than 1000 layers.
std::vector<Region> cut_into_layers(const std::vector<Region>& regions, const Layers& layers);

/// Region -> rotation of the material frame, for the regions of a mesh that cut_into_layers made.
std::map<int, Eigen::Matrix3d> frames_of(const Layers& layers, const TetMesh& mesh);

/// Every number of the layers, for recipes.
std::string text_of(const Layers& layers);

}  // namespace cleave::mesh
