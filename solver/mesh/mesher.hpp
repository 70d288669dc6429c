#pragma once

#include "solver/mesh/size_tuning.hpp"
#include "solver/mesh/surface_mesh.hpp"

#include <string>
#include <vector>

namespace cleave::mesh {

/// NETGEN: the paper's mesher, best shapes, one region, runs in a child process since it aborts on bad surfaces.
/// Gmsh: Delaunay, several regions in recipes; of a surface it keeps the triangles as they are.
enum class Mesher { netgen, gmsh };

/// "netgen", "gmsh".
const std::vector<std::string>& mesher_names();
std::string name_of(Mesher mesher);
/// Throws std::invalid_argument that lists the names.
Mesher mesher_of(const std::string& name);
/// Name and version, for recipes' texts and provenance.
std::string version_of(Mesher mesher);

/// Meshes the inside of a surface that passed check_surface() with tets of edge length `size` (m); NETGEN makes the surface's triangles anew.
/// All tets have region 1; the boundary faces carry the patch of the input triangle they lie on (nearest, facing the same way).
/// The same input gives the same bits. Each tet has a positive volume (checked). Throws MeshingError with the mesher's own words.
TetMesh mesh_surface(const SurfaceMesh& surface, double size, Mesher mesher);

/// mesh_surface at the size whose count comes closest to `target` (tune_count); NETGEN's tets may become smaller inside than at the surface, where
/// no one size meets the target.
TunedMesh mesh_surface_to_count(const SurfaceMesh& surface, int target, Mesher mesher);

}  // namespace cleave::mesh
