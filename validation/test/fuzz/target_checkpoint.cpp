#include "solver/input/file_io.hpp"
#include "solver/simulation/state.hpp"
#include "validation/test/fuzz/target.hpp"

#include <stdexcept>

namespace cleave::fuzz {

namespace {

using namespace simulation;

constexpr const char* scene_text = "name = \"fuzz\"";

/// One of each thing that a state may hold.
State full_state() {
    State state;
    state.frame = 7;
    state.pieces.resize(2);
    state.pieces[1].shape.points.push_back({1, 2, 3});
    state.pieces[1].shape.outer.push_back({0, 0, 0});
    state.bodies.resize(1);
    OpenedCrack opened;
    opened.crack.region = 2;
    state.bodies[0].history = {opened, {}};
    state.bodies[0].results.resize(2);
    state.world.next_id = 2;
    state.world.bodies.resize(1);
    state.world.ignored_pairs = {{0, 1}};
    state.descriptions.resize(1);
    state.descriptions[0].spheres.resize(1);
    state.descriptions[0].hull.resize(1, Eigen::Vector3d::Ones());
    state.tracks.resize(1);
    state.tracks[0].name = "body";
    state.tracks[0].keys.resize(2);
    state.impacts.resize(1);
    state.impacts[0].principals = {1};
    state.impacts[0].normals = {Eigen::Vector3d::UnitX()};
    return state;
}

/// The bytes with the checksum that belongs to them, where they have the length for one.
std::string with_right_checksum(const std::string& bytes) {
    static const std::string empty = checkpoint_bytes({}, scene_text);
    static const std::size_t hash_length = content_hash("").size();
    static const std::size_t head = empty.find(content_hash(scene_text)) - sizeof(std::uint64_t) - hash_length;  // the payload starts with the scene's hash
    if (bytes.size() < head + hash_length) return bytes;
    return bytes.substr(0, head) + content_hash(std::string_view(bytes).substr(head + hash_length)) + bytes.substr(head + hash_length);
}

void read_both_ways(const std::string& bytes) {
    const std::string whole = with_right_checksum(bytes);
    const State state = read_checkpoint(whole, scene_text, "input.cleave");
    if (checkpoint_bytes(state, scene_text) != whole) throw std::logic_error("other bytes than those that were read");
}

}  // namespace

Target checkpoint_target() { return {"checkpoint", {checkpoint_bytes({}, scene_text), checkpoint_bytes(full_state(), scene_text)}, read_both_ways}; }

}  // namespace cleave::fuzz
