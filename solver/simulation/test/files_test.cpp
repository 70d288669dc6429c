// The files a run leaves: VTU and glTF read back by small readers of the test's own.

#include "solver/simulation/animation.hpp"
#include "solver/simulation/vtu_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include <cstring>
#include <regex>

namespace cleave::simulation {
namespace {

template <class Value>
Value read_at(const std::string& bytes, std::size_t place) {
    Value value;
    std::memcpy(&value, bytes.data() + place, sizeof value);
    return value;
}

/// Undoes VTK's compressed blocks, by its file format's definition.
std::string inflated(const std::string& file, std::size_t place) {
    const auto blocks = read_at<std::uint64_t>(file, place), size = read_at<std::uint64_t>(file, place + 8), last = read_at<std::uint64_t>(file, place + 16);
    std::string out;
    std::size_t data = place + 24 + 8 * blocks;
    for (std::uint64_t i = 0; i < blocks; ++i) {
        const auto packed = read_at<std::uint64_t>(file, place + 24 + 8 * i);
        uLongf length = i + 1 == blocks && last > 0 ? last : size;
        std::string block(length, '\0');
        EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(block.data()), &length, reinterpret_cast<const Bytef*>(file.data() + data), packed), Z_OK);
        block.resize(length);
        out += block;
        data += packed;
    }
    return out;
}

/// The bytes of a named array.
std::string array_of(const std::string& file, const std::string& name) {
    std::smatch match;
    const std::regex tag("Name=\"" + name + "\"[^>]*offset=\"([0-9]+)\"");
    EXPECT_TRUE(std::regex_search(file, match, tag)) << name;
    const std::size_t start = file.find("encoding=\"raw\">\n_") + std::strlen("encoding=\"raw\">\n_");
    return inflated(file, start + std::stoul(match[1]));
}

VtuGrid two_tets() {
    VtuGrid grid;
    grid.points = 5;
    grid.cells = 2;
    grid.positions = float_array("positions", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1});
    grid.connectivity = int_array("connectivity", {0, 1, 2, 3, 1, 2, 3, 4});
    grid.offsets = int_array("offsets", {4, 8});
    grid.types = byte_array("types", {10, 10});
    grid.cell_data = {float_array("stress", 6, std::vector<float>(12, 2.5F))};
    return grid;
}

TEST(VtuFile, ComesBackAsItWas) {
    VtuGrid grid = two_tets();
    const std::string file = vtu_bytes(grid);
    EXPECT_NE(file.find("NumberOfPoints=\"5\" NumberOfCells=\"2\""), std::string::npos);
    EXPECT_EQ(array_of(file, "positions"), grid.positions.bytes);
    EXPECT_EQ(array_of(file, "connectivity"), grid.connectivity.bytes);
    EXPECT_EQ(array_of(file, "types"), std::string("\n\n"));
    EXPECT_EQ(array_of(file, "stress").size(), 48u);
}

TEST(VtuFile, ManyBlocks) {
    std::vector<float> values(700'000);  // 2.8 MB: three blocks, the last not full
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 977);
    VtuArray array = float_array("a", 1, values);
    compress(array);
    EXPECT_EQ(read_at<std::uint64_t>(array.compressed, 0), 3u);
    EXPECT_EQ(inflated(array.compressed, 0), array.bytes);
}

TEST(VtuFile, EmptyGridIsAFileToo) {
    VtuGrid grid = two_tets();
    grid.points = grid.cells = 0;
    for (VtuArray* array : {&grid.positions, &grid.connectivity, &grid.offsets, &grid.types, &grid.cell_data[0]}) array->bytes.clear();
    EXPECT_EQ(array_of(vtu_bytes(grid), "positions"), "");
}

TEST(PvdFile, NamesItsFrames) {
    EXPECT_NE(pvd_text({{0.5, "frames/00015.vtu"}}).find("<DataSet timestep=\"0.5\" part=\"0\" file=\"frames/00015.vtu\"/>"), std::string::npos);
}

/// A triangle that comes at frame 2, moves, and goes at frame 5; and one that stays.
std::vector<Track> two_tracks() {
    Track moving, still;
    moving.name = "moving";
    moving.shape.points = still.shape.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    moving.shape.outer = still.shape.outer = {{0, 1, 2}};
    moving.shape.crack = {{0, 2, 1}};
    for (int frame = 2; frame < 5; ++frame) moving.add(key_of(frame, Eigen::Matrix3d::Identity(), {0, 0, 1.0 * frame}));
    moving.end = 5;
    for (int frame = 0; frame < 9; ++frame) still.add(key_of(frame, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()));
    return {moving, still};
}

nlohmann::json json_of_glb(const std::string& glb) {
    EXPECT_EQ(glb.substr(0, 4), "glTF");
    EXPECT_EQ(read_at<std::uint32_t>(glb, 4), 2u);
    EXPECT_EQ(read_at<std::uint32_t>(glb, 8), glb.size());
    return nlohmann::json::parse(glb.substr(20, read_at<std::uint32_t>(glb, 12)));
}

/// The floats of an accessor.
std::vector<float> floats_of(const std::string& glb, const nlohmann::json& json, int accessor, int components) {
    const auto& view = json["bufferViews"][json["accessors"][accessor]["bufferView"].get<int>()];
    const std::size_t binary = 20 + read_at<std::uint32_t>(glb, 12) + 8, offset = view.value("byteOffset", 0);
    std::vector<float> values;
    for (int i = 0; i < components * json["accessors"][accessor]["count"].get<int>(); ++i) values.push_back(read_at<float>(glb, binary + offset + 4 * i));
    return values;
}

TEST(Glb, ThingsAppearAndGoByAStepOfScale) {
    const std::string glb = glb_bytes(two_tracks(), 10, 8);
    const nlohmann::json json = json_of_glb(glb);
    ASSERT_EQ(json["meshes"].size(), 2u);
    EXPECT_EQ(json["meshes"][0]["primitives"].size(), 2u);  // outer and crack faces, each its material
    EXPECT_NE(json["meshes"][0]["primitives"][0]["material"], json["meshes"][0]["primitives"][1]["material"]);
    const auto& animation = json["animations"][0];
    int scales = 0;
    for (const auto& channel : animation["channels"]) {
        if (channel["target"]["path"] != "scale") continue;
        ++scales;
        const auto& sampler = animation["samplers"][channel["sampler"].get<int>()];
        EXPECT_EQ(sampler["interpolation"], "STEP");
        EXPECT_EQ(floats_of(glb, json, sampler["input"], 1), (std::vector<float>{0, 0.2F, 0.5F}));
        EXPECT_EQ(floats_of(glb, json, sampler["output"], 3), (std::vector<float>{0, 0, 0, 1, 1, 1, 0, 0, 0}));
    }
    EXPECT_EQ(scales, 1);  // the one that is always there needs none
}

TEST(Glb, WhatStaysHasTwoKeys) {
    EXPECT_EQ(two_tracks()[1].keys.size(), 2u);
    EXPECT_EQ(two_tracks()[1].keys.back().frame, 8);
    EXPECT_EQ(two_tracks()[0].keys.size(), 3u);
}

TEST(Glb, QuaternionsDoNotJump) {
    Track track = two_tracks()[1];
    track.keys.clear();
    for (int frame = 0; frame < 40; ++frame) {
        const double angle = 0.3 * frame;
        Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
        turn.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        track.add(key_of(frame, turn, Eigen::Vector3d::Zero()));
    }
    const std::string glb = glb_bytes({track}, 10, 39);
    const nlohmann::json json = json_of_glb(glb);
    const auto& animation = json["animations"][0];
    for (const auto& channel : animation["channels"]) {
        if (channel["target"]["path"] != "rotation") continue;
        const std::vector<float> q = floats_of(glb, json, animation["samplers"][channel["sampler"].get<int>()]["output"], 4);
        for (std::size_t i = 4; i < q.size(); i += 4) {
            float dot = 0;
            for (std::size_t k = 0; k < 4; ++k) dot += q[i + k] * q[i + k - 4];
            EXPECT_GT(dot, 0.9);  // cos(0.15)
        }
    }
}

}  // namespace
}  // namespace cleave::simulation
