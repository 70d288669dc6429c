// Bad scenes, checkpoints and results.

#include "validation/test/robustness/bad_input.hpp"

#include <gtest/gtest.h>

namespace cleave::robustness {
namespace {

const std::string tets = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n"
                         "$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 4 2 1 1 2 3 4 5\n$EndElements\n";

const std::string good_scene = R"(name = "good"
frames = 2
frame_rate = "30 Hz"
substeps = 4
[ground]
height = "0 m"
[contact]
friction = 0.5
restitution = 0.1
[[body]]
mesh = "good.msh"
material = "soda-lime glass"
strength = "50 MPa"
position = ["0 m", "0 m", "2 m"]
groups = 2
kernel = { tensor = "wpca", scale = [1, 1, 1] }
[analysis]
displacement = "half_space"
[fracture]
debris_below = "0.1 g"
[collision]
shape = "spheres"
)";

BadInput bad_scene(const std::string& name, const std::string& from, const std::string& to, std::vector<std::string> told) {
    told.insert(told.begin(), "bad.toml");
    return {name, "simulate bad.toml --out out", {{"bad.toml", changed(good_scene, from, to)}, {"good.msh", tets}}, std::move(told)};
}

BadInput call(const std::string& name, const std::string& command, std::vector<std::string> told, int code = 2) {
    return {name, command, {{"good.toml", good_scene}, {"good.msh", tets}}, std::move(told), code};
}

std::vector<BadInput> bad_scenes() {
    BadInput foreign = call("checkpoint_of_something_else", "simulate good.toml --out out --restart other.cleave", {"other.cleave"});
    foreign.files["other.cleave"] = "not a checkpoint";
    BadInput cut = call("checkpoint_empty", "simulate good.toml --out out --restart other.cleave", {"other.cleave"});
    cut.files["other.cleave"] = "";
    return {
        {"scene_empty", "simulate bad.toml --out out", {{"bad.toml", ""}}, {"bad.toml", "name"}},
        {"scene_missing", "simulate none.toml --out out", {}, {"none.toml"}},
        {"scene_unknown_name", "simulate no_such_scene --out out", {}, {"no_such_scene", "pot_adaptive"}},
        bad_scene("scene_without_bodies", good_scene.substr(good_scene.find("[[body]]"), good_scene.find("[analysis]") - good_scene.find("[[body]]")), "", {"body"}),
        bad_scene("frames_zero", "frames = 2", "frames = 0", {"frames"}),
        bad_scene("frames_negative", "frames = 2", "frames = -2", {"frames"}),
        bad_scene("frames_huge", "frames = 2", "frames = 99999999999", {"frames"}),
        bad_scene("frame_rate_zero", "\"30 Hz\"", "\"0 Hz\"", {"frame_rate"}),
        bad_scene("frame_rate_nan", "\"30 Hz\"", "\"nan Hz\"", {"frame_rate"}),
        bad_scene("frame_rate_of_a_length", "\"30 Hz\"", "\"30 m\"", {"frame_rate"}),
        bad_scene("substeps_zero", "substeps = 4", "substeps = 0", {"substeps"}),
        bad_scene("substeps_huge", "substeps = 4", "substeps = 2000000000", {"substeps"}),
        bad_scene("friction_negative", "friction = 0.5", "friction = -0.5", {"friction"}),
        bad_scene("restitution_two", "restitution = 0.1", "restitution = 2", {"restitution"}),
        bad_scene("groups_zero", "groups = 2", "groups = 0", {"groups"}),
        bad_scene("groups_negative", "groups = 2", "groups = -1", {"groups"}),
        bad_scene("groups_more_than_particles", "groups = 2", "groups = 3", {"groups"}),
        bad_scene("body_without_mesh_file", "\"good.msh\"", "\"none.msh\"", {"none.msh"}),
        bad_scene("body_material_unknown", "\"soda-lime glass\"", "\"unobtainium\"", {"material", "unobtainium"}),
        bad_scene("body_strength_negative", "\"50 MPa\"", "\"-50 MPa\"", {"strength"}),
        bad_scene("body_strength_of_a_mass", "\"50 MPa\"", "\"50 kg\"", {"strength"}),
        bad_scene("body_position_of_two", "[\"0 m\", \"0 m\", \"2 m\"]", "[\"0 m\", \"0 m\"]", {"position"}),
        bad_scene("body_position_infinite", "\"2 m\"", "\"inf m\"", {"position"}),
        bad_scene("kernel_unknown", "\"wpca\"", "\"cubic\"", {"kernel.tensor", "wpca"}),
        bad_scene("kernel_scale_zero", "[1, 1, 1]", "[1, 0, 1]", {"kernel.scale"}),
        bad_scene("recipe_unknown", "mesh = \"good.msh\"", "recipe = { name = \"teapot\" }", {"recipe", "teapot"}),
        bad_scene("recipe_of_no_particles", "mesh = \"good.msh\"", "recipe = { name = \"pot\", particles = 0 }", {"particles"}),
        bad_scene("recipe_of_ten_billion", "mesh = \"good.msh\"", "recipe = { name = \"pot\", particles = 10000000000 }", {"particles"}),
        bad_scene("ball_of_no_size", "mesh = \"good.msh\"", "ball = { radius = \"0 m\" }", {"ball"}),
        bad_scene("displacement_unknown", "\"half_space\"", "\"quarter_space\"", {"analysis.displacement", "half_space"}),
        bad_scene("debris_negative", "\"0.1 g\"", "\"-0.1 g\"", {"debris_below"}),
        bad_scene("collision_unknown", "\"spheres\"", "\"cubes\"", {"collision.shape", "spheres"}),
        bad_scene("scene_unknown_key", "substeps = 4", "substep = 4", {"substep", "substeps"}),
        call("simulate_frames_of_words", "simulate good.toml --out out --frames many", {"--frames"}),
        call("simulate_threads_zero", "simulate good.toml --out out --threads 0", {"--threads"}),
        call("simulate_override_of_nothing", "simulate good.toml --out out --set body[0].colour=1", {"colour"}),
        call("simulate_override_of_no_body", "simulate good.toml --out out --set body[7].groups=1", {"body"}),
        call("simulate_restart_missing", "simulate good.toml --out out --restart none.cleave", {"none.cleave"}),
        call("simulate_unwritable", "simulate good.toml --out /proc/cleave", {"/proc"}, 3),
        foreign,
        cut,
    };
}

BadInput bad_results(const std::string& name, const std::string& bytes, std::vector<std::string> told) {
    told.insert(told.begin(), "results.json");
    return {name, "report --from . --out out", {{"results.json", bytes}}, std::move(told)};
}

std::vector<BadInput> bad_result_files() {
    return {
        {"results_missing", "report --from . --out out", {}, {"results.json"}},
        {"results_folder_missing", "report --from none --out out", {}, {"none"}},
        bad_results("results_empty", "", {"expected"}),
        bad_results("results_not_json", "{\"schema\": ", {"expected"}),
        bad_results("results_of_an_older_schema", "{\"schema\": \"cleave.results/0\", \"cases\": []}", {"cleave.results/1"}),
        bad_results("results_a_list", "[]", {"expected"}),
        bad_results("results_cases_a_number", "{\"schema\": \"cleave.results/1\", \"level\": \"quick\", \"cases\": 3}", {"cases"}),
        bad_results("results_deeply_nested", std::string(200000, '[') + std::string(200000, ']'), {"expected"}),
        bad_results("results_binary", std::string("\xff\xfe\x00\x01", 4), {"expected"}),
    };
}

class BadScene : public testing::TestWithParam<BadInput> {};

TEST_P(BadScene, GetsOneLine) { EXPECT_EQ(complaint(GetParam()), ""); }

INSTANTIATE_TEST_SUITE_P(Scenes, BadScene, testing::ValuesIn(bad_scenes()), [](const auto& info) { return info.param.name; });
INSTANTIATE_TEST_SUITE_P(Results, BadScene, testing::ValuesIn(bad_result_files()), [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace cleave::robustness
