#include "solver/mesh/recipes/recipes.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/paths.hpp"
#include "solver/input/read_values.hpp"
#include "solver/mesh/gmsh_session.hpp"
#include "solver/mesh/import.hpp"
#include "solver/mesh/recipes/occ_body.hpp"
#include "solver/mesh/recipes/pet.hpp"
#include "solver/mesh/recipes/pot.hpp"
#include "solver/mesh/recipes/tai_chi.hpp"
#include "solver/mesh/recipes/window.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace cleave::mesh {
namespace {

constexpr int surface_particles = 5000;
constexpr int most_particles = 100'000'000;

OccBody occ_body(const std::string& name) {
    if (name == "pot") return pot_body(PotShape{});
    if (name == "window") return window_body();
    if (name == "pet") return pet_body();
    return tai_chi_body();
}

const RecipeInfo& recipe_named(const std::string& name) {
    const auto found = std::find_if(recipes().begin(), recipes().end(), [&](const RecipeInfo& info) { return info.name == name; });
    if (found != recipes().end()) return *found;
    throw InputError("", "recipe", fmt::format("one of {} (not '{}')", fmt::join(recipe_names(), ", "), name));
}

Body recipe_body(const BodySource& source, const std::filesystem::path& cache) {
    const RecipeInfo& info = recipe_named(source.recipe);
    const OccRequest request{.target = source.particles > 0 ? source.particles : info.particles,
                             .mesher = source.mesher.value_or(source.layers ? Mesher::gmsh : info.mesher),
                             .layers = source.layers};
    return mesh_occ_body(occ_body(info.name), request, cache);
}

Body surface_body(const SurfaceMesh& surface, const BodySource& source, const std::filesystem::path& cache) {
    const Mesher mesher = source.mesher.value_or(Mesher::netgen);
    const int target = source.particles > 0 ? source.particles : surface_particles;
    const std::string name = source.file.stem().string();
    const std::string recipe = fmt::format("surface 1 {}: target {}, {}", content_hash(read_file(source.file)), target, version_of(mesher));
    return cached_body(name, recipe, target, cache, [&] { return mesh_surface_to_count(surface, target, mesher).mesh; });
}

Body file_body(const BodySource& source, const std::filesystem::path& cache) {
    Imported imported = import_mesh(source.file);
    if (const auto* surface = std::get_if<SurfaceMesh>(&imported)) return surface_body(*surface, source, cache);
    auto& tets = std::get<TetMesh>(imported);
    const int count = static_cast<int>(tets.tets.size());
    if (source.particles > 0 || source.mesher) throw InputError(source.file.string(), "", "a surface: these are tets already, whose count cannot be chosen");
    Body body = cached_body("imported", source.file.string(), count, {}, [&] { return std::move(tets); });
    body.record.target = 0;  // nobody asked for a count
    return body;
}

double read_angle(TableReader& table, const std::string& text) {
    try {
        const Quantity quantity = parse_quantity(text);
        if (quantity.angle) return quantity.value;
    } catch (const std::invalid_argument&) {
        // not a quantity at all: said below
    }
    table.fail("angles", fmt::format("angles like \"30 deg\", not '{}'", text));
}

Layers read_layers(TableReader table) {
    Layers layers;
    const std::array<double, 3> normal = table.has("normal") ? read_direction(table, "normal") : std::array<double, 3>{0, 0, 1};
    layers.normal = {normal[0], normal[1], normal[2]};
    layers.thickness = table.quantity("thickness", dimension::length);
    if (!(layers.thickness > 0)) table.fail("thickness", "more than 0");
    for (const std::string& angle : table.strings("angles")) layers.angles.push_back(read_angle(table, angle));
    if (layers.angles.empty()) table.fail("angles", "at least one angle");
    return layers;
}

void read_count_and_mesher(TableReader& table, BodySource& source) {
    if (table.has("particles")) {
        const long particles = table.integer("particles");
        if (particles < 1 || particles > most_particles) table.fail("particles", fmt::format("1 to {}", most_particles));
        source.particles = static_cast<int>(particles);
    }
    if (table.has("mesher")) source.mesher = mesher_of(table.choice("mesher", mesher_names()));
}

void read_recipe(TableReader table, BodySource& source) {
    source.recipe = table.choice("name", recipe_names());
    read_count_and_mesher(table, source);
    if (auto layers = table.table_if("layers")) source.layers = read_layers(*layers);
}

std::filesystem::path found_file(const TableReader& table, const std::string& key, const std::string& name) {
    std::filesystem::path file = find_beside(name, table.file());
    if (!is_file(file)) table.fail(key, fmt::format("an existing file (not '{}')", name));
    return file;
}

void read_surface(TableReader table, BodySource& source) {
    source.file = found_file(table, "file", table.string("file"));
    read_count_and_mesher(table, source);
}

}  // namespace

const std::vector<RecipeInfo>& recipes() {
    static const std::vector<RecipeInfo> list{
        {"pot", "a vessel: a profile with a wall, revolved (Figs. 7, 8, 10)", 6163, Mesher::netgen, {"pot"}},
        {"window", "a slab of glass (Fig. 9)", 1743, Mesher::netgen, {"window"}},
        {"pet", "a hollow animal on four legs (Fig. 11)", 23664, Mesher::gmsh, {"pet"}},
        {"tai_chi", "a disc of two materials, split by the S-curve, with dots (Fig. 12)", 3880, Mesher::gmsh, {"yin", "yang"}}};
    return list;
}

std::vector<std::string> recipe_names() {
    std::vector<std::string> names;
    for (const RecipeInfo& info : recipes()) names.push_back(info.name);
    return names;
}

BodySource read_body_source(TableReader& body) {
    BodySource source;
    if (body.has("recipe") + body.has("mesh") + body.has("surface") != 1) body.fail("", "exactly one of 'recipe', 'mesh' and 'surface'");
    if (body.has("recipe")) read_recipe(body.table("recipe"), source);
    else if (body.has("mesh")) source.file = found_file(body, "mesh", body.string("mesh"));
    else if (body.raw("surface").starts_with('{')) read_surface(body.table("surface"), source);
    else source.file = found_file(body, "surface", body.string("surface"));
    return source;
}

Body make_body(const BodySource& source, const std::filesystem::path& cache) {
    return source.recipe.empty() ? file_body(source, cache) : recipe_body(source, cache);
}

}  // namespace cleave::mesh
