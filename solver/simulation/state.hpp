#pragma once

#include "solver/fragments/mass_properties.hpp"
#include "solver/rigid/world.hpp"
#include "solver/simulation/animation.hpp"
#include "solver/simulation/scene_body.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cleave::simulation {

/// A whole body or a fragment, somewhere in the scene.
struct Piece {
    std::int32_t body = 0;       ///< in the scene
    std::int32_t fragment = 0;   ///< of that body; 0 for a ball
    std::int32_t rigid = -1;     ///< in the world; -1: debris
    std::int32_t track = -1;     ///< in the animation; -1: not seen yet
    std::int32_t boundary_particles = 0;
    bool held = false;
    bool lies = false;           ///< debris that has reached the ground
    fragments::MassProperties mass;
    rigid::Motion motion;        ///< of debris
    Shape shape;                 ///< moves into the track when that begins
};

/// One analysed contact: what was hit, how, and what came of it.
struct ImpactRecord {
    std::int32_t frame = 0;
    std::int32_t body = 0, fragment = 0;
    double speed = 0;             ///< m/s
    double effective_mass = 0;    ///< kg
    double force = 0;             ///< N, Hertz's peak
    double contact_radius = 0;    ///< m
    Eigen::Vector3d point = Eigen::Vector3d::Zero(), inward = Eigen::Vector3d::UnitZ();  ///< rest coordinates
    std::vector<double> principals;         ///< largest principal value of each group: Pa, or strain
    std::vector<Eigen::Vector3d> normals;   ///< of the cracks, rest coordinates
    std::vector<double> outer_radii, inner_radii;  ///< m
    std::int32_t fragments = 1;   ///< into which the piece fell
};

/// What statistics.json tells besides counts: worst figures of the whole run.
struct Watch {
    double momentum_error = 0;          ///< linear, through a fracture, relative to mass times the fastest point's speed
    double angular_momentum_error = 0;  ///< relative to that times the size
    double mass_error = 0;              ///< relative
    double energy_growth = 0;           ///< J, of a piece in a step in which nothing touched it
    double energy_scale = 0;            ///< J, largest kinetic energy of the scene
    double penetration = 0;             ///< m
    std::int32_t boundary_at_start = 0;  ///< boundary particles
    std::int32_t steps = 0;
    std::int64_t free_steps = 0;         ///< of single pieces that nothing touched: those energy_growth is the largest of
    std::int32_t fractures = 0;         ///< contacts whose cracks changed a piece
};

/// One body's cracks: what a restart repeats.
struct BodyState {
    std::vector<OpenedCrack> history;
    std::vector<ParticleResult> results;
};

/// Everything that the future of a scene depends on, and its past as the animation shows it.
struct State {
    std::int32_t frame = 0;
    std::vector<Piece> pieces;   ///< in the order of their birth
    std::vector<BodyState> bodies;
    rigid::WorldState world;
    std::vector<rigid::BodyDescription> descriptions;  ///< of world.bodies
    std::vector<Track> tracks;
    std::vector<ImpactRecord> impacts;
    Watch watch;
};

/// Bytes of a state: a magic word, a version, a checksum of the rest, the scene's fingerprint.
std::string checkpoint_bytes(const State& state, const std::string& scene_text);

/// Throws InputError that names `file`: no checkpoint, another version, damaged, of another scene.
State read_checkpoint(const std::string& bytes, const std::string& scene_text, const std::string& file);

}  // namespace cleave::simulation
