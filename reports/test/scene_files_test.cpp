#include "reports/scene_files.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using namespace cleave::reports;

class SceneFiles : public testing::Test {
protected:
    void write(const std::string& name, const std::string& text) const { cleave::write_file_atomic(folder_ / "scenes" / name, text); }
    cleave::ScratchFolder folder_;
};

const std::string statistics = R"({"schema": "cleave.statistics/1"})";

// RFC 4648, section 10.
TEST_F(SceneFiles, FoldersWithStatisticsAreScenes) {
    EXPECT_EQ(read_scenes(folder_).size(), 0U);
    write("b/statistics.json", statistics);
    write("a/statistics.json", statistics);
    write("a/timings.json", "{}");
    write("a/surface.glb", "glTF....");
    write("c/notes.txt", "no scene");
    const auto scenes = read_scenes(folder_);
    ASSERT_EQ(scenes.size(), 2U);
    EXPECT_EQ(scenes[0]["name"], "a");
    EXPECT_EQ(scenes[0]["surface"], "Z2xURi4uLi4=");
    EXPECT_TRUE(scenes[1]["surface"].is_null());
    EXPECT_EQ(scenes[1]["note"], "no surface.glb");
    EXPECT_TRUE(scenes[1]["timings"].is_null());
}

TEST_F(SceneFiles, TheSmallSurfacesFitTheLargeOneIsLeftOut) {
    write("large/statistics.json", statistics);
    write("large/surface.glb", "glTF" + std::string(23'999'000, 'x'));
    write("small/statistics.json", statistics);
    write("small/surface.glb", "glTF" + std::string(2000, 'x'));
    const auto scenes = read_scenes(folder_);
    EXPECT_TRUE(scenes[0]["surface"].is_null());
    EXPECT_NE(scenes[0]["note"].get<std::string>().find("24.0 MB"), std::string::npos) << scenes[0]["note"];
    EXPECT_FALSE(scenes[1]["surface"].is_null());
}

TEST_F(SceneFiles, WhatIsNoSceneIsRefused) {
    write("a/statistics.json", R"({"schema": "cleave.statistics/2"})");
    EXPECT_THROW(read_scenes(folder_), cleave::InputError);
    write("a/statistics.json", statistics);
    write("a/surface.glb", "PK..");
    EXPECT_THROW(read_scenes(folder_), cleave::InputError);
    write("a/surface.glb", "glTF");
    write("a/timings.json", "[");
    EXPECT_THROW(read_scenes(folder_), cleave::InputError);
}

}  // namespace
