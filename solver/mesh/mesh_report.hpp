#pragma once

#include "solver/mesh/recipes/body.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace cleave::mesh {

/// What `cleave mesh --json` prints (schema "cleave.mesh/1"):
///
///   recipe, target (null for a file that holds tets), tets, vertices
///   smallest_dihedral_deg, slivers   tets with a dihedral angle under 5 degrees
///   volume_m3, surface_m2            of all tets, of their whole boundary
///   regions    [ { tag, name, tets, volume_m3 } ]
///   surfaces   [ { tag, name, triangles, area_m2 } ]   triangles with a tag
nlohmann::ordered_json mesh_json(const Body& body);

/// The same as a table for the terminal.
std::string mesh_text(const Body& body);

}  // namespace cleave::mesh
