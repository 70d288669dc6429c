#include "solver/simulation/scene.hpp"

#include "solver/elasticity/strain_operator.hpp"
#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/paths.hpp"
#include "solver/material/rotation.hpp"
#include "solver/simulation/scene_files.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cleave::simulation {
namespace {

Eigen::Vector3d eigen(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

Eigen::Vector3d vector_or_zero(TableReader& reader, const std::string& key, Dimension dimension) {
    return reader.has(key) ? eigen(reader.vector(key, dimension)) : Eigen::Vector3d(0, 0, 0);
}

void require(TableReader& reader, const std::string& key, bool fine, const std::string& expected) {
    if (!fine) reader.fail(key, expected);
}

double positive_or(TableReader& reader, const std::string& key, Dimension dimension, double fallback) {
    const double value = reader.quantity_or(key, dimension, fallback);
    require(reader, key, !reader.has(key) || value > 0, "a value above zero");
    return value;
}

double not_negative_or(TableReader& reader, const std::string& key, Dimension dimension, double fallback) {
    const double value = reader.quantity_or(key, dimension, fallback);
    require(reader, key, value >= 0, "a value of at least zero");
    return value;
}

int integer_at_least(TableReader& reader, const std::string& key, int least, int fallback) {
    const long value = reader.integer_or(key, fallback);
    require(reader, key, value >= least && value <= 1'000'000'000, fmt::format("an integer of at least {}", least));
    return static_cast<int>(value);
}

bool is_text(TableReader& reader, const std::string& key) {
    const std::string raw = reader.raw(key);
    return raw.starts_with('"') || raw.starts_with('\'');
}

material::Material read_elastic(TableReader& body, const std::string& key) {
    if (!is_text(body, key)) {
        TableReader table = body.table(key);
        return material::read_material(table);
    }
    const std::string name = body.string(key);
    if (name.ends_with(".toml")) return material::read_material_file(find_beside(name, body.file()).string());
    if (!material::in_catalogue(name)) body.fail(key, fmt::format("a material of the catalogue ({}) or a FILE.toml (not '{}')", fmt::join(material::catalogue_names(), ", "), name));
    return material::find_material(name);
}

/// `key`: where the material stands; `limits`: where the keys of read_brittleness do.
BodyMaterial with_limits(material::Material elastic, const TableReader& reader, const std::string& key, TableReader& limits, bool breakable) {
    BodyMaterial out{std::move(elastic), {}};
    if (!(out.elastic.density > 0)) reader.fail(key, "a material with a density");
    if (breakable) out.brittleness = fracture::read_brittleness(limits, out.elastic.strength, out.elastic.toughness, out.elastic.stiffness);
    return out;
}

BodyMaterial read_body_material(TableReader& body, bool breakable) { return with_limits(read_elastic(body, "material"), body, "material", body, breakable); }

/// A region's own material; in a table of keys those of read_brittleness stand too.
BodyMaterial read_region_material(TableReader& regions, const std::string& region, bool breakable) {
    if (is_text(regions, region)) {
        TableReader none = TableReader::from_text("", regions.file());
        return with_limits(read_elastic(regions, region), regions, region, none, breakable);
    }
    TableReader table = regions.table(region);
    return with_limits(material::read_material(table), regions, region, table, breakable);
}

KernelSpec read_kernel(TableReader& body) {
    KernelSpec kernel;
    std::optional<TableReader> table = body.table_if("kernel");
    if (!table) return kernel;
    kernel.wpca = table->choice_or("tensor", {"wpca", "isotropic"}, "wpca") == "wpca";
    if (table->has("scale")) {
        const std::vector<double> scale = table->numbers("scale");
        require(*table, "scale", scale.size() == 3 && scale[0] > 0 && scale[1] > 0 && scale[2] > 0, "three numbers above zero");
        kernel.scale = {scale[0], scale[1], scale[2]};
    }
    if (table->boolean_or("keep_volume", false)) kernel.scale /= std::cbrt(kernel.scale.prod());
    kernel.support = table->number_or("support", kernel.support);
    require(*table, "support", kernel.support >= 1 && kernel.support <= 10, "a number from 1 to 10, in local spacings");
    return kernel;
}

std::vector<Eigen::AlignedBox3d> read_held(TableReader& body) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (TableReader& box : body.tables_if("held")) {
        boxes.emplace_back(eigen(box.vector("low", dimension::length)), eigen(box.vector("high", dimension::length)));
        require(box, "high", !boxes.back().isEmpty(), "a corner above 'low' in every coordinate");
    }
    return boxes;
}

void read_shape(TableReader& reader, BodySpec& body) {
    if (reader.has("ball")) {
        TableReader ball = reader.table("ball");
        body.ball_radius = ball.quantity("radius", dimension::length);
        require(ball, "radius", body.ball_radius > 0, "a value above zero");
        for (const char* other : {"recipe", "mesh", "surface"}) require(reader, other, !reader.has(other), "no 'ball' beside it");
        require(reader, "breakable", !reader.boolean_or("breakable", false), "false: balls do not break");
        body.breakable = false;
    } else {
        body.source = mesh::read_body_source(reader);
        body.breakable = reader.boolean_or("breakable", true);
    }
}

BodySpec read_body(TableReader& reader, int number) {
    BodySpec body;
    body.name = reader.string_or("name", fmt::format("body{}", number));
    read_shape(reader, body);
    body.material = read_body_material(reader, body.breakable);
    if (std::optional<TableReader> regions = reader.table_if("region_materials"))
        for (const std::string& region : regions->keys()) body.region_materials[region] = read_region_material(*regions, region, body.breakable);
    body.rotation = material::read_rotation(reader);
    body.position = vector_or_zero(reader, "position", dimension::length);
    body.velocity = vector_or_zero(reader, "velocity", dimension::velocity);
    body.angular_velocity = vector_or_zero(reader, "angular_velocity", dimension::frequency);
    body.kernel = read_kernel(reader);
    body.groups = integer_at_least(reader, "groups", 1, body.groups);
    body.thickness = positive_or(reader, "thickness", dimension::length, 0);
    body.contact_radius = positive_or(reader, "contact_radius", dimension::length, 0);
    body.held = read_held(reader);
    return body;
}

void read_surroundings(TableReader& reader, Scene& scene) {
    if (std::optional<TableReader> ground = reader.table_if("ground")) scene.ground = ground->quantity_or("height", dimension::length, 0);
    if (std::optional<TableReader> contact = reader.table_if("contact")) {
        scene.friction = contact->number_or("friction", scene.friction);
        require(*contact, "friction", scene.friction >= 0, "a number of at least 0");
        scene.restitution = contact->number_or("restitution", scene.restitution);
        require(*contact, "restitution", scene.restitution >= 0 && scene.restitution <= 1, "a number from 0 to 1");
    }
    if (std::optional<TableReader> collision = reader.table_if("collision")) {
        scene.hulls = collision->choice_or("shape", {"spheres", "hull"}, "spheres") == "hull";
        scene.boundary.group = integer_at_least(*collision, "group", 1, scene.boundary.group);
        scene.boundary.reach = collision->number_or("reach", scene.boundary.reach);
        require(*collision, "reach", scene.boundary.reach > 0, "a number above 0, in local spacings");
    }
}

void read_analysis(TableReader& reader, Scene& scene) {
    std::optional<TableReader> table = reader.table_if("analysis");
    if (!table) return;
    if (table->has("displacement"))
        scene.displacement = contact::displacement_source(table->choice("displacement", {"half_space", "equilibrium"}));
    std::vector<std::string> operators = elasticity::strain_operator_names();
    scene.strain_operator = table->choice_or("strain_operator", operators, scene.strain_operator);
    require(*table, "groups", !table->has("groups"), "this key in each [[body]]");
    fracture::read_options(*table, scene.analysis);
}

void read_fracture(TableReader& reader, Scene& scene) {
    std::optional<TableReader> table = reader.table_if("fracture");
    if (!table) return;
    scene.scheme = table->choice_or("scheme", {"adaptive", "basic"}, "adaptive") == "adaptive" ? fragments::Scheme::adaptive : fragments::Scheme::basic;
    scene.debris_below = not_negative_or(*table, "debris_below", dimension::mass, 0);
    scene.slowest_impact = not_negative_or(*table, "slowest_impact", dimension::velocity, scene.slowest_impact);
    scene.largest_radius = positive_or(*table, "largest_radius", dimension::length, scene.largest_radius);
}

void read_times(TableReader& reader, Scene& scene) {
    scene.frames = integer_at_least(reader, "frames", 1, scene.frames);
    scene.frame_rate = positive_or(reader, "frame_rate", dimension::frequency, scene.frame_rate);
    scene.substeps = integer_at_least(reader, "substeps", 1, scene.substeps);
    scene.travel = positive_or(reader, "travel", dimension::length, scene.travel);
    scene.checkpoint_every = integer_at_least(reader, "checkpoint_every", 0, scene.checkpoint_every);
    scene.gravity = {0, 0, -not_negative_or(reader, "gravity", dimension::acceleration, 9.81)};
}

std::string with_overrides(const std::string& text, const Overrides& overrides) {
    std::string out = text;
    for (const auto& [key, value] : overrides) out += fmt::format("\n# --set {}={}", key, value);
    return out;
}

}  // namespace

Scene read_scene(TableReader reader, const Overrides& overrides) {
    for (const auto& [key, value] : overrides) reader.set(key, value);
    Scene scene;
    scene.file = reader.file();
    scene.name = reader.string("name");
    scene.about = reader.string_or("about", "");
    read_times(reader, scene);
    read_surroundings(reader, scene);
    int number = 0;
    for (TableReader& body : reader.tables("body")) scene.bodies.push_back(read_body(body, number++));
    require(reader, "body", !scene.bodies.empty(), "at least one [[body]]");
    read_analysis(reader, scene);
    read_fracture(reader, scene);
    if (std::optional<TableReader> output = reader.table_if("output")) scene.vtu_every = integer_at_least(*output, "vtu_every", 0, scene.vtu_every);
    reader.finish();
    return scene;
}

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const SceneFile& file : scene_files()) names.push_back(std::filesystem::path(file.name).stem().string());
    return names;
}

Scene find_scene(const std::string& what, const Overrides& overrides) {
    for (const SceneFile& file : scene_files()) {
        if (std::filesystem::path(file.name).stem() != what) continue;
        Scene scene = read_scene(TableReader::from_text(file.text, "scenes/" + file.name), overrides);
        scene.text = with_overrides(file.text, overrides);
        return scene;
    }
    if (!what.ends_with(".toml")) throw InputError("", "scene", fmt::format("one of {}, or a FILE.toml (not '{}')", fmt::join(scene_names(), ", "), what));
    Scene scene = read_scene(TableReader::from_file(what), overrides);
    scene.text = with_overrides(read_file(what), overrides);
    return scene;
}

}  // namespace cleave::simulation
