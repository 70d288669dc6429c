// A small scene from beginning to end: a glass block of 384 tets falls on a corner and breaks.

#include "solver/simulation/run.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "solver/mesh/msh_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <random>

namespace cleave::simulation {
namespace {

namespace fs = std::filesystem;

/// A block of n x n x n cubes, each of six tets about its diagonal (Kuhn).
mesh::TetMesh block(int n, double size) {
    mesh::TetMesh mesh;
    const auto number = [n](int x, int y, int z) { return (z * (n + 1) + y) * (n + 1) + x; };
    for (int z = 0; z <= n; ++z)
        for (int y = 0; y <= n; ++y)
            for (int x = 0; x <= n; ++x) mesh.vertices.emplace_back(size * x / n, size * y / n, size * z / n);
    constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                for (const auto& order : orders) {
                    std::array<int, 3> corner{x, y, z};
                    std::array<int, 4> tet{number(x, y, z), 0, 0, 0};
                    for (int k = 0; k < 3; ++k) {
                        ++corner[static_cast<std::size_t>(order[k])];
                        tet[static_cast<std::size_t>(k) + 1] = number(corner[0], corner[1], corner[2]);
                    }
                    mesh.tets.push_back(tet);
                    if (mesh::tet_volume(mesh, static_cast<int>(mesh.tets.size()) - 1) < 0) std::swap(mesh.tets.back()[0], mesh.tets.back()[1]);
                }
    mesh.regions.assign(mesh.tets.size(), 1);
    return mesh;
}

class Run : public ::testing::Test {
protected:
    void SetUp() override { mesh::write_msh(block(4, 0.08), root_ / "block.msh"); }

    Scene scene(const Overrides& overrides = {}) const {
        const std::string text = fmt::format(R"(
name = "block"
frames = 24
checkpoint_every = 8
travel = "2 mm"
[ground]
[[body]]
mesh = "{}"
material = "soda-lime glass"
strength = "5 MPa"
groups = 6
position = ["0 m", "0 m", "0.08 m"]
rotation = [{{ axis = [1, 0, 0], angle = "40 deg" }}, {{ axis = [0, 1, 0], angle = "30 deg" }}]
velocity = ["0.3 m/s", "0 m/s", "-3 m/s"]
angular_velocity = ["1 Hz", "2 Hz", "0 Hz"]
[analysis]
grouping = "k_means"
[fracture]
debris_below = "1 g"
)", (root_ / "block.msh").string());
        Scene scene = read_scene(TableReader::from_text(text, (root_ / "block.toml").string()), overrides);
        scene.text = text;
        return scene;
    }

    RunResult run(const Scene& scene, const std::string& folder, RunOptions options = {}) const {
        options.out = root_.path() / folder;
        return run_scene(scene, options);
    }

    nlohmann::json statistics(const std::string& folder) const { return nlohmann::json::parse(read_file(root_.path() / folder / "statistics.json")); }

    /// All files of a run but its timings and, where asked, its checkpoints.
    std::map<std::string, std::string> files(const std::string& folder, bool checkpoints = true) const {
        std::map<std::string, std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(root_.path() / folder)) {
            const std::string name = fs::relative(entry.path(), root_.path() / folder).string();
            if (!entry.is_regular_file() || name == "timings.json" || (!checkpoints && name.starts_with("checkpoint"))) continue;
            found[name] = read_file(entry.path());
        }
        return found;
    }

    cleave::ScratchFolder root_;
};

/// Names of files that differ, so that a failure does not print megabytes.
std::string differences(const std::map<std::string, std::string>& a, const std::map<std::string, std::string>& b) {
    std::string names;
    for (const auto& [name, bytes] : a)
        if (!b.contains(name) || b.at(name) != bytes) names += name + " ";
    for (const auto& [name, bytes] : b)
        if (!a.contains(name)) names += name + " ";
    return names;
}

TEST_F(Run, ABlockBreaksAndNothingIsLost) {
    const RunResult result = run(scene(), "a");
    EXPECT_FALSE(result.interrupted);
    const nlohmann::json json = statistics("a");
    EXPECT_EQ(json["schema"], "cleave.statistics/1");
    EXPECT_EQ(json["physical_particles"], 384);
    EXPECT_GT(json["subdivided_particles"], 384);
    EXPECT_GT(json["fragments"], 1);
    EXPECT_GT(json["impacts"].size(), 0u);
    EXPECT_NEAR(json["mass"].get<double>(), 2500 * 0.08 * 0.08 * 0.08, 1e-12);  // density times volume, debris counted
    EXPECT_LT(json["mass_error"].get<double>(), 1e-12);
    EXPECT_LT(json["momentum_error"].get<double>(), 1e-10);          // the issue's figure; sums of a few hundred tets give 1e-15
    EXPECT_LT(json["angular_momentum_error"].get<double>(), 1e-10);
    EXPECT_GT(json["free_steps_of_pieces"], 0);
    // Free flight loses energy (symplectic Euler, implicit gyroscopic term); what rounding may add is a 1e-12 of it.
    EXPECT_LT(json["energy_growth_without_contact"].get<double>(), 1e-9 * json["largest_kinetic_energy"].get<double>());
    EXPECT_TRUE(fs::exists(root_ / "a/surface.glb"));
    EXPECT_TRUE(fs::exists(root_ / "a/frames/00024.vtu"));
    EXPECT_EQ(nlohmann::json::parse(read_file(root_ / "a/timings.json"))["frames"], 24);
}

TEST_F(Run, PoorNeighbourhoodsAreTold) {
    const auto told = [&](int cells) {
        mesh::write_msh(block(cells, 0.08), root_ / "block.msh");
        const RunResult result = run(scene({{"analysis.strain_operator", "\"quadratic\""}, {"frames", "1"}}), fmt::format("of{}", cells));
        const nlohmann::json json = statistics(fmt::format("of{}", cells))["strain_operators"].at(0);
        EXPECT_EQ(json["particles"], 6 * cells * cells * cells);
        EXPECT_NE(result.summary.find(fmt::format("strain operator quadratic: {} supports enlarged, {} still poor, {} fallbacks",
                                                  json["raised_supports"].get<int>(), json["poor_supports"].get<int>(), json["fallbacks"].get<int>())),
                  std::string::npos);
        return json["fallbacks"].get<int>();
    };
    EXPECT_EQ(told(1), 6);  // five neighbours do not determine nine derivatives
    EXPECT_EQ(told(4), 0);
}

TEST_F(Run, AStrongBlockStaysWhole) {  // the twin: with a strength that nothing reaches nothing breaks
    run(scene({{"body[0].strength", "\"1 TPa\""}}), "a");
    const nlohmann::json json = statistics("a");
    EXPECT_EQ(json["fragments"], 1);
    EXPECT_EQ(json["subdivided_particles"], 384);
    EXPECT_GT(json["contacts_analysed"], 0);
}

TEST_F(Run, ThreadsDoNotChangeAByte) {
    for (const int threads : {1, 2, 4}) {
        RunOptions options;
        options.threads = threads;
        run(scene(), fmt::format("by{}", threads), options);
    }
    ASSERT_GT(statistics("by1")["fragments"], 1);
    EXPECT_EQ(differences(files("by1"), files("by2")), "");
    EXPECT_EQ(differences(files("by1"), files("by4")), "");
}

TEST_F(Run, ARestartGivesTheBytesOfTheUninterruptedRun) {
    run(scene(), "whole");
    ASSERT_GT(statistics("whole")["fragments"], 1);
    for (const int frame : {8, 16}) {
        const std::string folder = fmt::format("from{}", frame);
        RunOptions options;
        options.restart = root_ / fmt::format("whole/checkpoint-{:05}.cleave", frame);
        run(scene(), folder, options);
        std::map<std::string, std::string> expected = files("whole"), found = files(folder);
        for (int earlier = 8; earlier <= frame; earlier += 8) expected.erase(fmt::format("checkpoint-{:05}.cleave", earlier));
        EXPECT_EQ(differences(expected, found), "") << frame;
    }
}

TEST_F(Run, AStopLeavesAReadableResultAndTheRestGoesOn) {
    run(scene(), "whole");
    int frames = 0;
    RunOptions options;
    options.frame_done = [&](const Simulation&) { ++frames; };
    options.stop = [&] { return frames == 11; };
    const RunResult result = run(scene(), "stopped", options);
    EXPECT_TRUE(result.interrupted);
    EXPECT_EQ(result.frames, 11);
    EXPECT_TRUE(fs::exists(root_ / "stopped/surface.glb"));
    EXPECT_NE(read_file(root_ / "stopped/frames.pvd").find("frames/00011.vtu"), std::string::npos);
    EXPECT_EQ(read_file(root_ / "stopped/frames.pvd").find("frames/00012.vtu"), std::string::npos);
    RunOptions again;
    again.restart = root_ / "stopped/checkpoint-00008.cleave";
    run(scene(), "stopped", again);
    EXPECT_EQ(differences(files("whole"), files("stopped")), "");
}

TEST_F(Run, BadCheckpointsAreRefused) {
    const Scene one = scene({{"frames", "8"}});
    run(one, "a");
    const std::string good = read_file(root_ / "a/checkpoint-00008.cleave");
    EXPECT_NO_THROW(read_checkpoint(good, one.text, "c"));
    EXPECT_THROW(read_checkpoint("nonsense", one.text, "c"), InputError);
    EXPECT_THROW(read_checkpoint(good.substr(0, good.size() - 1), one.text, "c"), InputError);
    EXPECT_THROW(read_checkpoint(good, one.text + " ", "c"), InputError);  // another scene
    try {  // its first byte after the magic word is the version
        std::string older = good;
        older[std::string("cleave checkpoint\n").size()] = 1;
        read_checkpoint(older, one.text, "c");
        ADD_FAILURE() << "an older version was read";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("version 2 (not 1)"), std::string::npos) << error.what();
    }
}

TEST_F(Run, AThousandSingleBitFlipsAreRefused) {
    const Scene one = scene({{"frames", "8"}});
    run(one, "a");
    std::string bytes = read_file(root_ / "a/checkpoint-00008.cleave");
    std::mt19937 random(11);  // seeded
    std::uniform_int_distribution<std::size_t> place(0, 8 * bytes.size() - 1);
    for (int i = 0; i < 1000; ++i) {
        const std::size_t bit = place(random);
        const auto flip = [&] { bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8)); };
        flip();
        EXPECT_THROW(read_checkpoint(bytes, one.text, "c"), InputError) << "bit " << bit;
        flip();
    }
    EXPECT_NO_THROW(read_checkpoint(bytes, one.text, "c"));
}

TEST_F(Run, TheBasicSchemeKeepsItsParticles) {
    run(scene({{"fracture.scheme", "basic"}}), "a");
    EXPECT_EQ(statistics("a")["subdivided_particles"], 384);
    EXPECT_GT(statistics("a")["fragments"], 1);
}

}  // namespace
}  // namespace cleave::simulation
