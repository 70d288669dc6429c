#include "solver/simulation/scene.hpp"

#include "solver/input/input_error.hpp"

#include <gtest/gtest.h>

namespace cleave::simulation {
namespace {

const std::string body = "[[body]]\nball = { radius = \"3 cm\" }\nmaterial = \"steel\"\n";

Scene read(const std::string& text, const Overrides& overrides = {}) { return read_scene(TableReader::from_text(text, "s.toml"), overrides); }

/// The key that an InputError names.
std::string fault(const std::string& text, const Overrides& overrides = {}) {
    try {
        read(text, overrides);
    } catch (const InputError& error) {
        return error.key();
    }
    return "none";
}

TEST(Scene, DefaultsAreThoseOfTheDocumentation) {
    const Scene scene = read("name = \"s\"\n" + body);
    EXPECT_EQ(scene.frames, 200);
    EXPECT_EQ(scene.frame_rate, 30);
    EXPECT_EQ(scene.substeps, 4);
    EXPECT_EQ(scene.checkpoint_every, 50);
    EXPECT_EQ(scene.gravity, Eigen::Vector3d(0, 0, -9.81));
    EXPECT_FALSE(std::isfinite(scene.ground));
    EXPECT_EQ(scene.strain_operator, "corrected");
    EXPECT_EQ(scene.scheme, fragments::Scheme::adaptive);
    EXPECT_EQ(scene.bodies.at(0).name, "body0");
    EXPECT_EQ(scene.bodies[0].groups, 2);
    EXPECT_FALSE(scene.bodies[0].breakable);
}

TEST(Scene, ValuesAreReadInTheirUnits) {
    const Scene scene = read("name = \"s\"\nframe_rate = \"25 Hz\"\ntravel = \"2 mm\"\n" + body +
                             "position = [\"0 m\", \"1 cm\", \"1 mm\"]\nvelocity = [\"0 m/s\", \"0 m/s\", \"-3 m/s\"]\n[ground]\n[fracture]\ndebris_below = \"0.1 g\"\n");
    EXPECT_EQ(scene.frame_rate, 25);
    EXPECT_DOUBLE_EQ(scene.travel, 0.002);
    EXPECT_DOUBLE_EQ(scene.bodies[0].position[1], 0.01);
    EXPECT_EQ(scene.bodies[0].velocity[2], -3);
    EXPECT_EQ(scene.ground, 0);
    EXPECT_DOUBLE_EQ(scene.debris_below, 1e-4);
}

TEST(Scene, KernelScaleMayKeepItsVolume) {
    const Scene scene = read("name = \"s\"\n[[body]]\nrecipe = { name = \"pot\" }\nmaterial = \"porcelain\"\nkernel = { scale = [3, 3, 1], keep_volume = true }\n");
    const Eigen::Vector3d& scale = scene.bodies[0].kernel.scale;
    EXPECT_NEAR(scale.prod(), 1, 1e-14);
    EXPECT_NEAR(scale[0] / scale[2], 3, 1e-14);
}

TEST(Scene, ARegionsMaterialBringsItsOwnLimits) {
    const Scene scene = read("name = \"s\"\n[[body]]\nrecipe = { name = \"tai_chi\" }\nmaterial = \"porcelain\"\nfibre = { direction = [1, 0, 0], ratio = 3 }\n"
                             "[body.region_materials]\nyin = \"alumina\"\n[body.region_materials.yang]\nname = \"alumina\"\ntoughness = \"5 J/m^2\"\n"
                             "fibre = { direction = [0, 1, 0], ratio = 2 }\n");
    const BodySpec& body = scene.bodies.at(0);
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY();
    const auto ratio = [](const BodyMaterial& material, const Eigen::Vector3d& normal) { return material.brittleness.toughness.intensity_ratio(normal); };
    EXPECT_DOUBLE_EQ(ratio(body.material, x), 3);
    EXPECT_DOUBLE_EQ(ratio(body.region_materials.at("yin"), x), 1);  // a name alone: the body's fibres are not its
    EXPECT_DOUBLE_EQ(ratio(body.region_materials.at("yang"), y), 2);
    EXPECT_DOUBLE_EQ(ratio(body.region_materials.at("yang"), x), 1);
    EXPECT_DOUBLE_EQ(body.region_materials.at("yang").brittleness.toughness.energy(x), 5);
}

TEST(Scene, OverridesReachIntoBodies) {
    const Scene scene = read("name = \"s\"\n" + body, {{"frames", "7"}, {"body[0].position", "[\"0 m\", \"0 m\", \"2 m\"]"}});
    EXPECT_EQ(scene.frames, 7);
    EXPECT_EQ(scene.bodies[0].position[2], 2);
    EXPECT_THROW(read("name = \"s\"\n" + body, {{"body[1].groups", "3"}}), InputError);
}

TEST(Scene, MistakesAreNamed) {
    EXPECT_EQ(fault("name = \"s\"\n"), "body");
    EXPECT_EQ(fault(body), "name");
    EXPECT_EQ(fault("name = \"s\"\nframe = 3\n" + body), "frame");                  // unknown key
    EXPECT_EQ(fault("name = \"s\"\nframes = 0\n" + body), "frames");
    EXPECT_EQ(fault("name = \"s\"\ngravity = \"9.81\"\n" + body), "gravity");        // no unit
    EXPECT_EQ(fault("name = \"s\"\n" + body + "groups = 0\n"), "body[0].groups");
    EXPECT_EQ(fault("name = \"s\"\n" + body + "breakable = true\n"), "body[0].breakable");
    EXPECT_EQ(fault("name = \"s\"\n[[body]]\nball = { radius = \"3 cm\" }\nmaterial = \"stele\"\n"), "body[0].material");
    EXPECT_EQ(fault("name = \"s\"\n[[body]]\nball = { radius = \"-3 cm\" }\nmaterial = \"steel\"\n"), "body[0].ball.radius");
    EXPECT_EQ(fault("name = \"s\"\n" + body + "[fracture]\nscheme = \"fast\"\n"), "fracture.scheme");
    EXPECT_EQ(fault("name = \"s\"\n" + body + "[analysis]\nstrain_operator = \"exact\"\n"), "analysis.strain_operator");
    EXPECT_EQ(fault("name = \"s\"\n" + body + "[contact]\nrestitution = 2\n"), "contact.restitution");
    EXPECT_EQ(fault("name = \"s\"\n[[body]]\nrecipe = { name = \"pot\" }\nmaterial = \"silicon\"\n"), "body[0].strength");  // none given, none known
}

TEST(Scene, EveryShippedSceneReads) {
    for (const std::string& name : scene_names()) {
        const Scene scene = find_scene(name);
        EXPECT_EQ(scene.name, name);
        EXPECT_GE(scene.frames, 200) << name;  // "no less than 200 frames", Sect. 6.2
    }
    EXPECT_THROW(find_scene("vase"), InputError);
}

}  // namespace
}  // namespace cleave::simulation
