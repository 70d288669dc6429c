#pragma once

#include "solver/input/table_reader.hpp"
#include "solver/mesh/mesher.hpp"
#include "solver/mesh/recipes/body.hpp"
#include "solver/mesh/recipes/layers.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cleave::mesh {

/// A body that this folder can make.
struct RecipeInfo {
    std::string name, about;
    int particles = 0;                 ///< the paper's count (Table 1)
    Mesher mesher = Mesher::netgen;    ///< where none is asked for
    std::vector<std::string> regions;  ///< names of the regions 1, 2, ...; without layers
};

/// pot, window, pet, tai_chi.
const std::vector<RecipeInfo>& recipes();
std::vector<std::string> recipe_names();

/// Where a body's tets come from: the keys `recipe`, `mesh` or `surface` of a scene's [[body]].
struct BodySource {
    std::string recipe;            ///< name; empty for a file
    std::filesystem::path file;    ///< tets, or a surface; empty for a recipe
    int particles = 0;             ///< tets asked for, within 2 %; 0: the recipe's own count; for a surface: 5000; for tets as they are
    std::optional<Mesher> mesher;  ///< none: the recipe's own; NETGEN for a surface
    std::optional<Layers> layers;  ///< cuts a recipe's body into layers (Sect. 5.1); by Gmsh
    friend bool operator==(const BodySource&, const BodySource&) = default;
};

/// Reads exactly one of
///   recipe  = { name = "pot", particles = 6163, mesher = "netgen", layers = { normal = [0, 0, 1], thickness = "2 cm", angles = ["0 deg", "90 deg"] } }
///   mesh    = "file.msh|.mesh|.vtu"  (tets)
///   surface = "file.stl|.obj|..." or { file = "...", particles = 5000, mesher = "netgen" }
/// File names are relative to the current folder, else to the folder of the TOML file. Throws InputError.
BodySource read_body_source(TableReader& body);

/// The body, from `cache` (a folder; empty: none) where it was made before. Throws InputError for what the source asks wrongly
/// (unknown recipe, a surface that cannot be meshed), MeshingError where a mesher fails or the count misses by more than 2 %.
Body make_body(const BodySource& source, const std::filesystem::path& cache = {});

}  // namespace cleave::mesh
