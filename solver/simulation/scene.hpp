#pragma once

#include "solver/contact/contact_displacement.hpp"
#include "solver/fracture/options.hpp"
#include "solver/fracture/toughness.hpp"
#include "solver/fragments/crack.hpp"
#include "solver/input/table_reader.hpp"
#include "solver/material/material.hpp"
#include "solver/mesh/recipes/recipes.hpp"
#include "solver/rigid/boundary_particles.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cleave::simulation {

/// A material of a scene's body, and what decides about its cracks.
struct BodyMaterial {
    material::Material elastic;
    fracture::Brittleness brittleness;
};

/// How a body's kernels are shaped (Sect. 4.1).
struct KernelSpec {
    bool wpca = true;                                       ///< false: isotropic
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();        ///< on the axes, the last is the surface normal
    double support = 2.5;                                   ///< k, support radius in local spacings
};

/// One [[body]].
struct BodySpec {
    std::string name;
    std::optional<mesh::BodySource> source;   ///< tets; none: a ball
    double ball_radius = 0;                   ///< m, of an unbreakable ball
    bool breakable = true;
    BodyMaterial material;
    std::map<std::string, BodyMaterial> region_materials;   ///< by the mesh's region names, in the place of `material`
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d position = Eigen::Vector3d::Zero();          ///< m, where the mesh's origin comes to lie
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< m/s
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s
    KernelSpec kernel;
    int groups = 2;
    double thickness = 0;                     ///< m, B of Eq. 11; 0: 2 V / A of the mesh
    double contact_radius = 0;                ///< m, of the surface's curvature at a contact; 0: that of the boundary particle hit
    std::vector<Eigen::AlignedBox3d> held;    ///< m, rest coordinates: fragments with a particle in one of these do not move
};

/// One scene file; the defaults are those of an absent key.
struct Scene {
    std::string file, name, about;
    int frames = 200;
    double frame_rate = 30;                   ///< Hz
    int substeps = 4;                         ///< per frame, at least
    double travel = std::numeric_limits<double>::infinity();  ///< m: more substeps where something moves farther than this in one
    int checkpoint_every = 50;                ///< frames; 0: none
    Eigen::Vector3d gravity{0, 0, -9.81};     ///< m/s^2
    double ground = -std::numeric_limits<double>::infinity();  ///< m; -infinity: none
    double friction = 0.5, restitution = 0.1;
    std::vector<BodySpec> bodies;
    contact::DisplacementSource displacement = contact::DisplacementSource::half_space;
    std::string strain_operator = "corrected";
    fracture::Options analysis;               ///< groups are the body's own
    fragments::Scheme scheme = fragments::Scheme::adaptive;
    double debris_below = 0;                  ///< kg
    double slowest_impact = 0.5;              ///< m/s: slower contacts are not analysed
    double largest_radius = std::numeric_limits<double>::infinity();  ///< m, caps r_outer besides the body's own size
    bool hulls = false;                       ///< collide as convex hulls instead of boundary particles
    rigid::BoundaryRule boundary;
    int vtu_every = 1;                        ///< frames; 0: none
    std::string text;                         ///< the file's text and the overrides: what a checkpoint is compared with
};

using Overrides = std::vector<std::pair<std::string, std::string>>;  ///< dotted key, TOML value

/// Reads a scene. All keys are optional but `name` and one [[body]]:
///
///   name, about, frames = 200, frame_rate = "30 Hz", substeps = 4, travel = "2 mm", checkpoint_every = 50, gravity = "9.81 m/s^2"
///   [ground]    height = "0 m"                                    no table: no ground
///   [contact]   friction = 0.5, restitution = 0.1
///   [[body]]    recipe | mesh | surface (mesh::read_body_source) or ball = { radius = "3 cm" }
///               name, material = "porcelain" | "FILE.toml" | { keys of [material] }, region_materials = { NAME = material, ... }
///               (in a table of keys: those of read_brittleness too)
///               position, velocity ["1 m", ...], angular_velocity ["1 Hz", ...] (rad/s), rotation = { axis, angle } or several
///               kernel = { tensor = "wpca" | "isotropic", scale = [1, 1, 1], keep_volume = false, support = 2.5 }
///               groups = 2, breakable = true, thickness = "1 cm", contact_radius = "1 m"
///               held = [{ low = ["0 m", ...], high = [...] }, ...]
///               strength, strain_limit, toughness, weak_plane, fibre (fracture::read_brittleness)
///   [analysis]  displacement = "half_space" | "equilibrium", strain_operator = "corrected", and those of fracture::read_options
///   [fracture]  scheme = "adaptive" | "basic", debris_below = "0 g", slowest_impact = "0.5 m/s", largest_radius = "1 m"
///   [collision] shape = "spheres" | "hull", group = 4, reach = 1.75
///   [output]    vtu_every = 1
///
/// Throws InputError: unknown keys, values out of range.
Scene read_scene(TableReader reader, const Overrides& overrides = {});

/// The shipped scenes' names, sorted.
std::vector<std::string> scene_names();

/// A shipped scene by name, or a file. Throws InputError that lists the names.
Scene find_scene(const std::string& what, const Overrides& overrides = {});

}  // namespace cleave::simulation
