#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace cleave::simulation {

/// What one thing of the animation looks like, in the rest coordinates of its body (single precision: for the eye).
struct Shape {
    std::vector<std::array<float, 3>> points;                    ///< m
    std::vector<std::array<std::uint32_t, 3>> outer, crack;      ///< triangles: the body's own surface, and what cracks made
};

/// Where a thing is at one frame: x = rotation x0 + translation.
struct Key {
    std::int32_t frame = 0;
    std::array<float, 4> rotation{0, 0, 0, 1};  ///< quaternion x, y, z, w
    std::array<float, 3> translation{};         ///< m
    bool same_place(const Key& other) const { return rotation == other.rotation && translation == other.translation; }
};

Key key_of(int frame, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation);

/// A body or a fragment: seen from its first key's frame on, until `end` (excluded).
struct Track {
    std::string name;
    std::int32_t colour = 0;        ///< which body's materials
    Shape shape;
    std::vector<Key> keys;          ///< ascending frames; one that stays where it was has only the ends of that time
    std::int32_t end = -1;          ///< frame from which it is gone; -1: never
    void add(const Key& key);
};

/// One .glb with all tracks: linear interpolation of places, and a scale that steps from 0 to 1 where a thing appears and back where it goes.
/// Outer and crack faces carry separate materials. `frame_rate` in Hz, frames 0..last. z is up here and y in glTF: the root turns it.
std::string glb_bytes(const std::vector<Track>& tracks, double frame_rate, int last_frame);

}  // namespace cleave::simulation
