#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/simulation/archive.hpp"
#include "solver/simulation/state.hpp"

#include <fmt/format.h>

// The descriptions below serve writing and reading alike (archive.hpp). A change of any of them asks for a new version.

namespace cleave::subdivision {
template <class Archive>
void fields(Archive& archive, Cut& cut) {
    archive(cut.centre, cut.normal, cut.radius);
}
}  // namespace cleave::subdivision

namespace cleave::fragments {
template <class Archive>
void fields(Archive& archive, Crack& crack) {
    archive(crack.disc, crack.inner_radius, crack.region);
}
template <class Archive>
void fields(Archive& archive, MassProperties& mass) {
    archive(mass.volume, mass.mass, mass.centre, mass.inertia);
}
}  // namespace cleave::fragments

namespace cleave::rigid {
template <class Archive>
void fields(Archive& archive, Sphere& sphere) {
    archive(sphere.centre, sphere.radius);
}
template <class Archive>
void fields(Archive& archive, BodyDescription& body) {
    archive(body.mass, body.centre, body.inertia, body.spheres, body.hull, body.held);
}
template <class Archive>
void fields(Archive& archive, Motion& motion) {
    archive(motion.rotation, motion.translation, motion.velocity, motion.angular_velocity);
}
template <class Archive>
void fields(Archive& archive, BodyState& state) {
    archive(state.id, state.basis, state.origin, state.velocity, state.angular_velocity, state.idle_time, state.activation);
}
template <class Archive>
void fields(Archive& archive, WorldState& world) {
    archive(world.next_id, world.bodies, world.ignored_pairs);
}
}  // namespace cleave::rigid

namespace cleave::simulation {

template <class Archive>
void fields(Archive& archive, OpenedCrack& opened) {
    archive(opened.crack, opened.fragment);
}
template <class Archive>
void fields(Archive& archive, ParticleResult& result) {
    archive(result.stress, result.energy_density);
}
template <class Archive>
void fields(Archive& archive, BodyState& body) {
    archive(body.history, body.results);
}
template <class Archive>
void fields(Archive& archive, Shape& shape) {
    archive(shape.points, shape.outer, shape.crack);
}
template <class Archive>
void fields(Archive& archive, Key& key) {
    archive(key.frame, key.rotation, key.translation);
}
template <class Archive>
void fields(Archive& archive, Track& track) {
    archive(track.name, track.colour, track.shape, track.keys, track.end);
}
template <class Archive>
void fields(Archive& archive, Piece& piece) {
    archive(piece.body, piece.fragment, piece.rigid, piece.track, piece.boundary_particles, piece.held, piece.lies, piece.mass, piece.motion, piece.shape);
}
template <class Archive>
void fields(Archive& archive, ImpactRecord& impact) {
    archive(impact.frame, impact.body, impact.fragment, impact.speed, impact.effective_mass, impact.force, impact.contact_radius, impact.point,
            impact.inward, impact.principals, impact.normals, impact.outer_radii, impact.inner_radii, impact.fragments);
}
template <class Archive>
void fields(Archive& archive, Watch& watch) {
    archive(watch.momentum_error, watch.angular_momentum_error, watch.mass_error, watch.energy_growth, watch.energy_scale, watch.penetration, watch.boundary_at_start, watch.steps,
            watch.free_steps, watch.fractures);
}
template <class Archive>
void fields(Archive& archive, State& state) {
    archive(state.frame, state.pieces, state.bodies, state.world, state.descriptions, state.tracks, state.impacts, state.watch);
}

namespace {

constexpr std::string_view magic = "cleave checkpoint\n";
constexpr std::uint32_t version = 2;
constexpr std::size_t hash_length = 16;

}  // namespace

std::string checkpoint_bytes(const State& state, const std::string& scene_text) {
    ArchiveWriter payload;
    payload(content_hash(scene_text), state);
    ArchiveWriter head;
    head(version);
    return std::string(magic) + head.bytes() + content_hash(payload.bytes()) + payload.bytes();
}

namespace {

/// What the checksum covers. Throws std::runtime_error where it cannot be what checkpoint_bytes wrote.
State read_payload(std::string_view payload, const std::string& scene_text, const std::string& file) {
    ArchiveReader reader(payload);
    std::string scene;
    State state;
    reader(scene);
    if (scene != content_hash(scene_text)) throw InputError(file, "", "a checkpoint of this scene with the same --set (this one is of another)");
    reader(state);
    if (!reader.at_end()) throw std::runtime_error("bytes behind its end");
    return state;
}

}  // namespace

State read_checkpoint(const std::string& bytes, const std::string& scene_text, const std::string& file) {
    if (!bytes.starts_with(magic)) throw InputError(file, "", "a checkpoint of cleave simulate");
    std::string_view rest = std::string_view(bytes).substr(magic.size());
    if (rest.size() < sizeof version + hash_length) throw InputError(file, "", "a whole checkpoint (this one ends too early)");
    std::uint32_t found = 0;
    ArchiveReader(rest.substr(0, sizeof version))(found);
    if (found != version) throw InputError(file, "", fmt::format("a checkpoint of version {} (not {})", version, found));
    rest.remove_prefix(sizeof version);
    const std::string_view hash = rest.substr(0, hash_length);
    rest.remove_prefix(hash_length);
    if (content_hash(rest) != hash) throw InputError(file, "", "an undamaged checkpoint (its checksum does not match)");
    try {
        return read_payload(rest, scene_text, file);
    } catch (const InputError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw InputError(file, "", fmt::format("a checkpoint as cleave simulate writes it (not {})", error.what()));
    }
}

}  // namespace cleave::simulation
