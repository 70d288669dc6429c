#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <Eigen/Core>

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace cleave::mesh {

/// What a recipe asked for and what came out.
struct BodyRecord {
    std::string recipe;                ///< the recipe's text: shape, sizes, target, mesher and its version
    int target = 0;                    ///< tets asked for
    int count = 0;                     ///< tets made
    double smallest_dihedral = 0;      ///< radians, over all tets
    int slivers = 0;                   ///< tets with a dihedral angle under 5 degrees
    friend bool operator==(const BodyRecord&, const BodyRecord&) = default;
};

struct Body {
    TetMesh mesh;
    BodyRecord record;
    /// Region -> rotation from the material's own axes to the body's, for regions that have one (layers).
    std::map<int, Eigen::Matrix3d> frames{};
};

/// Looks for FOLDER/NAME-HASH.msh, the hash being that of the recipe's text, and makes and stores the mesh where it is missing or
/// broken. The file keeps every bit, so that a cached body equals a fresh one. An empty folder means no cache. Throws what
/// `make` throws, and MeshingError where the count misses the target by more than 2 %.
Body cached_body(const std::string& name, const std::string& recipe, int target, const std::filesystem::path& folder,
                 const std::function<TetMesh()>& make);

}  // namespace cleave::mesh
