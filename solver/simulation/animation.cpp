#include "solver/simulation/animation.hpp"

#include <Eigen/Geometry>

// The implementation stands in the system's libtinygltf.
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace cleave::simulation {
namespace {

/// Appends arrays to the one buffer of the file, each with its view and accessor.
class GltfBuffer {
public:
    explicit GltfBuffer(tinygltf::Model& model) : model_(model) { model_.buffers.emplace_back(); }

    /// `values`: numbers of one component type, `count` elements of `type`. Returns the accessor.
    template <class Value>
    int add(const Value* values, std::size_t count, int type, int components, int component_type, int target) {
        std::vector<unsigned char>& data = model_.buffers[0].data;
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = data.size();
        view.byteLength = count * static_cast<std::size_t>(components) * sizeof(Value);
        view.target = target;
        const auto* bytes = reinterpret_cast<const unsigned char*>(values);
        data.insert(data.end(), bytes, bytes + view.byteLength);
        data.resize((data.size() + 3) / 4 * 4);
        model_.bufferViews.push_back(view);
        tinygltf::Accessor accessor;
        accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
        accessor.componentType = component_type;
        accessor.count = count;
        accessor.type = type;
        model_.accessors.push_back(accessor);
        return static_cast<int>(model_.accessors.size()) - 1;
    }

    int floats(const std::vector<float>& values, int type, int components) {
        return add(values.data(), values.size() / static_cast<std::size_t>(components), type, components, TINYGLTF_COMPONENT_TYPE_FLOAT, 0);
    }

    /// Accessors of times and positions need their bounds.
    void set_bounds(int accessor, std::vector<double> low, std::vector<double> high) {
        model_.accessors[static_cast<std::size_t>(accessor)].minValues = std::move(low);
        model_.accessors[static_cast<std::size_t>(accessor)].maxValues = std::move(high);
    }

    int times(const std::vector<float>& seconds) {
        const int accessor = floats(seconds, TINYGLTF_TYPE_SCALAR, 1);
        set_bounds(accessor, {seconds.front()}, {seconds.back()});
        return accessor;
    }

private:
    tinygltf::Model& model_;
};

constexpr int colours = 6;
// Outer faces: glazes; crack faces: the paler inside.
constexpr std::array<std::array<double, 3>, colours> outer_colour{
    {{0.16, 0.33, 0.55}, {0.62, 0.64, 0.66}, {0.55, 0.24, 0.15}, {0.22, 0.45, 0.32}, {0.50, 0.40, 0.16}, {0.35, 0.26, 0.46}}};
constexpr std::array<double, 3> crack_colour{0.89, 0.84, 0.76};

tinygltf::Material material(const std::string& name, const std::array<double, 3>& colour, double roughness) {
    tinygltf::Material out;
    out.name = name;
    out.pbrMetallicRoughness.baseColorFactor = {colour[0], colour[1], colour[2], 1};
    out.pbrMetallicRoughness.metallicFactor = 0;
    out.pbrMetallicRoughness.roughnessFactor = roughness;
    out.doubleSided = true;
    return out;
}

void add_primitive(tinygltf::Mesh& mesh, GltfBuffer& buffer, const std::vector<std::array<std::uint32_t, 3>>& triangles, int positions, int material) {
    if (triangles.empty()) return;
    tinygltf::Primitive primitive;
    primitive.attributes["POSITION"] = positions;
    primitive.indices = buffer.add(triangles.data()->data(), 3 * triangles.size(), TINYGLTF_TYPE_SCALAR, 1, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                                   TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    primitive.material = material;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    mesh.primitives.push_back(primitive);
}

tinygltf::Mesh mesh_of(const Track& track, GltfBuffer& buffer) {
    tinygltf::Mesh mesh;
    mesh.name = track.name;
    const auto& points = track.shape.points;
    const int positions = buffer.add(points.data()->data(), points.size(), TINYGLTF_TYPE_VEC3, 3, TINYGLTF_COMPONENT_TYPE_FLOAT,
                                     TINYGLTF_TARGET_ARRAY_BUFFER);
    std::vector<double> low(3, std::numeric_limits<double>::max()), high(3, std::numeric_limits<double>::lowest());
    for (const auto& point : points)
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min<double>(low[k], point[k]);
            high[k] = std::max<double>(high[k], point[k]);
        }
    buffer.set_bounds(positions, low, high);
    add_primitive(mesh, buffer, track.shape.outer, positions, track.colour % colours);
    add_primitive(mesh, buffer, track.shape.crack, positions, colours);
    return mesh;
}

/// A channel of the animation: values at times.
struct Channel {
    int node;
    const char* path;
    const char* interpolation;
    int input, output;
};

void add_channel(tinygltf::Animation& animation, const Channel& channel) {
    tinygltf::AnimationSampler sampler;
    sampler.input = channel.input;
    sampler.output = channel.output;
    sampler.interpolation = channel.interpolation;
    animation.samplers.push_back(sampler);
    tinygltf::AnimationChannel target;
    target.sampler = static_cast<int>(animation.samplers.size()) - 1;
    target.target_node = channel.node;
    target.target_path = channel.path;
    animation.channels.push_back(target);
}

/// The quaternion of two that means the same turn and lies nearer to the one before: players interpolate without asking.
std::array<float, 4> near(std::array<float, 4> q, const std::array<float, 4>& before) {
    float dot = 0;
    for (std::size_t k = 0; k < 4; ++k) dot += q[k] * before[k];
    if (dot < 0)
        for (float& x : q) x = -x;
    return q;
}

void animate_place(const Track& track, int node, double rate, GltfBuffer& buffer, tinygltf::Animation& animation) {
    std::vector<float> seconds, turns, places;
    std::array<float, 4> before = track.keys.front().rotation;
    for (const Key& key : track.keys) {
        before = near(key.rotation, before);
        seconds.push_back(static_cast<float>(key.frame / rate));
        turns.insert(turns.end(), before.begin(), before.end());
        places.insert(places.end(), key.translation.begin(), key.translation.end());
    }
    const int input = buffer.times(seconds);
    add_channel(animation, {node, "translation", "LINEAR", input, buffer.floats(places, TINYGLTF_TYPE_VEC3, 3)});
    add_channel(animation, {node, "rotation", "LINEAR", input, buffer.floats(turns, TINYGLTF_TYPE_VEC4, 4)});
}

/// 0 before the first key, 1 from it on, 0 again from the end on.
void animate_scale(const Track& track, int node, double rate, GltfBuffer& buffer, tinygltf::Animation& animation) {
    const int born = track.keys.front().frame;
    if (born == 0 && track.end < 0) return;
    std::vector<float> seconds, scales;
    const auto set = [&](int frame, float scale) {
        seconds.push_back(static_cast<float>(frame / rate));
        scales.insert(scales.end(), 3, scale);
    };
    if (born > 0) set(0, 0);
    set(born, 1);
    if (track.end >= 0) set(track.end, 0);
    add_channel(animation, {node, "scale", "STEP", buffer.times(seconds), buffer.floats(scales, TINYGLTF_TYPE_VEC3, 3)});
}

tinygltf::Node node_of(const Track& track, int mesh) {
    const Key& first = track.keys.front();
    tinygltf::Node node;
    node.name = track.name;
    node.mesh = mesh;
    node.translation = {first.translation.begin(), first.translation.end()};
    node.rotation = {first.rotation.begin(), first.rotation.end()};
    return node;
}

}  // namespace

Key key_of(int frame, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation) {
    const Eigen::Quaterniond q = Eigen::Quaterniond(rotation).normalized();
    const auto f = [](double x) { return static_cast<float>(x); };
    return {frame, {f(q.x()), f(q.y()), f(q.z()), f(q.w())}, {f(translation[0]), f(translation[1]), f(translation[2])}};
}

void Track::add(const Key& key) {
    const std::size_t n = keys.size();
    if (n >= 2 && keys[n - 1].same_place(key) && keys[n - 2].same_place(key)) keys.back().frame = key.frame;
    else keys.push_back(key);
}

std::string glb_bytes(const std::vector<Track>& tracks, double frame_rate, int last_frame) {
    tinygltf::Model model;
    model.asset.version = "2.0";
    model.asset.generator = "cleave";
    GltfBuffer buffer(model);
    for (int i = 0; i < colours; ++i) model.materials.push_back(material("outer " + std::to_string(i), outer_colour[static_cast<std::size_t>(i)], 0.35));
    model.materials.push_back(material("crack", crack_colour, 0.9));
    tinygltf::Animation animation;
    animation.name = "scene";
    tinygltf::Node root;
    root.name = "z up";
    const double half = std::sqrt(0.5);
    root.rotation = {-half, 0, 0, half};
    for (const Track& track : tracks) {
        if (track.keys.empty() || track.shape.points.empty() || track.keys.front().frame > last_frame) continue;
        model.meshes.push_back(mesh_of(track, buffer));
        model.nodes.push_back(node_of(track, static_cast<int>(model.meshes.size()) - 1));
        const int node = static_cast<int>(model.nodes.size()) - 1;
        animate_place(track, node, frame_rate, buffer, animation);
        animate_scale(track, node, frame_rate, buffer, animation);
        root.children.push_back(node);
    }
    model.nodes.push_back(root);
    if (!animation.channels.empty()) model.animations.push_back(animation);
    tinygltf::Scene scene;
    scene.nodes = {static_cast<int>(model.nodes.size()) - 1};
    model.scenes.push_back(scene);
    model.defaultScene = 0;
    std::ostringstream stream;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true)) throw std::runtime_error("glTF could not be written");
    return stream.str();
}

}  // namespace cleave::simulation
