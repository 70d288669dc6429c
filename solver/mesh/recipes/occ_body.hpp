#pragma once

#include "solver/mesh/mesher.hpp"
#include "solver/mesh/recipes/body.hpp"
#include "solver/mesh/recipes/layers.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cleave::mesh {

/// One part of a body: the volumes of a region.
struct Region {
    std::string name;
    std::vector<int> volumes;  ///< tags in the current Gmsh model
};

/// A recipe's body, built by Gmsh's OpenCASCADE kernel.
struct OccBody {
    std::string name;
    std::string parameters;                      ///< every number of the shape, for the cache
    std::function<std::vector<Region>()> build;  ///< leaves the volumes in the current model; regions 1, 2, ... in this order
    double first_size = 0;                       ///< m: a first guess of the mesh size
    double facet = 0;                            ///< m: edges of the surface triangles that NETGEN gets; 0: Gmsh only
};

struct OccRequest {
    int target = 0;  ///< tets
    Mesher mesher = Mesher::gmsh;
    std::optional<Layers> layers{};
};

/// The body as tets: region k named as the body's k-th, surface 1 "outside" (the whole surface). Gmsh meshes the exact shape; NETGEN, for
/// bodies of one region, the triangles that Gmsh made of its surface. `cache`: folder of stored meshes, empty for none. Throws MeshingError, also
/// for NETGEN on several regions or layers.
Body mesh_occ_body(const OccBody& body, const OccRequest& request, const std::filesystem::path& cache);

}  // namespace cleave::mesh
