// Bad cases and materials: one line that says file, key and what was expected; exit code 2; nothing left behind.

#include "validation/test/robustness/bad_input.hpp"

#include <gtest/gtest.h>

namespace cleave::robustness {
namespace {

const std::string good_case = R"(name = "good"
tier = "verification"
about = "small patch"
[geometry]
shape = "block"
extent = ["1 m", "1 m", "1 m"]
[material]
engineering = { E = "70 GPa", nu = 0.25 }
[load]
displacement = [{ on = "all", solution = "linear_displacement" }]
[ladder]
quick = [0.6]
[[check]]
quantity = "stress"
component = "xx"
at = [["0.5 m", "0.5 m", "0.5 m"]]
solver = ["fem.p1"]
reference = { solution = "linear_displacement" }
band = { relative = 1e-9 }
basis = "exact"
)";

const std::string good_penny = changed(changed(good_case, "shape = \"block\"\nextent = [\"1 m\", \"1 m\", \"1 m\"]",
                                               "shape = \"penny_crack_block\"\nhalf_width = \"4 m\"\ncrack_radius = \"1 m\""),
                                       "[{ on = \"all\", solution = \"linear_displacement\" }]", "[{ on = \"all\", vector = [\"0 m\", \"0 m\", \"0 m\"] }]");

BadInput bad_case(const std::string& name, const std::string& from, const std::string& to, std::vector<std::string> told) {
    told.insert(told.begin(), "bad.toml");
    return {name, "validate bad.toml --out out", {{"bad.toml", changed(good_case, from, to)}}, std::move(told)};
}

BadInput bad_text(const std::string& name, const std::string& text, std::vector<std::string> told) {
    return {name, "validate bad.toml --out out", {{"bad.toml", text}}, std::move(told)};
}

const std::string engineering = "engineering = { E = \"70 GPa\", nu = 0.25 }";

BadInput bad_stiffness(const std::string& name, const std::string& text, std::vector<std::string> told) {
    told.insert(told.begin(), "bad.toml");
    return {name, "material bad.toml", {{"bad.toml", text + "\n"}}, std::move(told)};
}

const std::string table_row = "9,0,0,0,0,0,8,0,0,0,0,7,0,0,0,6,0,0,5,0,4";

BadInput bad_table(const std::string& name, std::map<std::string, std::string> files, std::vector<std::string> told) {
    return {name, "validate material_sweep --set study.csv=table.csv --out out", std::move(files), std::move(told)};
}

std::vector<BadInput> bad_cases() {
    const std::string stiff = "stiffness = { unit = \"GPa\", voigt = ";
    return {
        bad_text("case_empty", "", {"bad.toml", "name: expected a string"}),
        bad_text("case_binary", std::string("\x7f" "ELF\x02\x01\x01\0\0\0\xff\xfe", 12), {"bad.toml:1"}),
        bad_text("case_truncated", good_case.substr(0, good_case.size() / 2), {"bad.toml"}),
        bad_text("case_a_key_twice", good_case + "basis = \"again\"\n", {"bad.toml:21", "basis"}),
        bad_text("case_no_checks", good_case.substr(0, good_case.find("[[check]]")), {"bad.toml", "check"}),
        {"case_missing", "validate none.toml --out out", {}, {"none.toml", "expected"}},
        {"case_is_a_folder", "validate folder.toml --out out", {{"folder.toml/file", "x"}}, {"folder.toml"}},
        bad_case("case_unknown_table", "[load]", "[laod]\nx = 1\n[load]", {"laod", "did you mean 'load'"}),
        bad_case("case_unknown_tier", "\"verification\"", "\"certainty\"", {"tier", "verification"}),
        bad_case("case_name_with_slashes", "name = \"good\"", "name = \"../../etc/good\"", {"name", "expected"}),
        bad_case("case_name_empty", "name = \"good\"", "name = \"\"", {"name", "expected"}),
        bad_case("size_zero", "[0.6]", "[0]", {"ladder.quick"}),
        bad_case("size_negative", "[0.6]", "[-0.6]", {"ladder.quick"}),
        bad_case("size_nan", "[0.6]", "[nan]", {"ladder.quick"}),
        bad_case("size_infinite", "[0.6]", "[inf]", {"ladder.quick"}),
        bad_case("size_for_ten_million_million_tets", "[0.6]", "[1e-5]", {"ladder.quick", "tets"}),
        bad_case("size_rising", "[0.6]", "[0.3, 0.6]", {"ladder.quick", "coarse to fine"}),
        bad_case("ladder_empty", "[0.6]", "[]", {"ladder.quick"}),
        bad_case("extent_zero", "[\"1 m\", \"1 m\", \"1 m\"]", "[\"0 m\", \"1 m\", \"1 m\"]", {"geometry.extent", "positive"}),
        bad_case("extent_two_numbers", "[\"1 m\", \"1 m\", \"1 m\"]", "[\"1 m\", \"1 m\"]", {"geometry.extent", "three"}),
        bad_case("extent_without_unit", "[\"1 m\", \"1 m\", \"1 m\"]", "[1, 1, 1]", {"geometry.extent", "unit"}),
        bad_case("extent_nan", "[\"1 m\", \"1 m\", \"1 m\"]", "[\"nan m\", \"1 m\", \"1 m\"]", {"geometry.extent"}),
        bad_case("extent_overflows", "[\"1 m\", \"1 m\", \"1 m\"]", "[\"1e999 m\", \"1 m\", \"1 m\"]", {"geometry.extent"}),
        bad_case("unit_of_another_quantity", "\"70 GPa\"", "\"70 kg\"", {"material.engineering.E", "kg"}),
        bad_case("unit_unknown", "\"70 GPa\"", "\"70 furlong\"", {"material.engineering.E", "furlong"}),
        bad_case("solution_unknown", "displacement = [{ on = \"all\", solution = \"linear_displacement\" }]",
                 "displacement = [{ on = \"all\", solution = \"quartic\" }]", {"load.displacement[0].solution", "quartic"}),
        bad_case("load_on_no_surface", "on = \"all\"", "on = \"lid\"", {"load.displacement[0].on", "lid"}),
        bad_case("load_missing", "[{ on = \"all\", solution = \"linear_displacement\" }]", "[]", {"fem.p1", "hold it by displacements"}),
        bad_case("quantity_unknown", "\"stress\"", "\"stres\"", {"check[0].quantity", "stress"}),
        bad_case("component_unknown", "\"xx\"", "\"xw\"", {"check[0].component", "xw"}),
        bad_case("solver_unknown", "[\"fem.p1\"]", "[\"fem.p7\"]", {"check[0].solver", "fem.p1"}),
        bad_case("solver_none", "[\"fem.p1\"]", "[]", {"check[0].solver"}),
        bad_case("band_negative", "relative = 1e-9", "relative = -1e-9", {"check[0].band", "positive"}),
        bad_case("band_infinite", "relative = 1e-9", "relative = inf", {"check[0].band"}),
        bad_case("band_unknown_kind", "relative = 1e-9", "roughly = 1e-9", {"check[0].band", "relative"}),
        bad_case("band_without_basis", "basis = \"exact\"\n", "", {"check[0].basis"}),
        bad_case("reference_without_source", "{ solution = \"linear_displacement\" }\nband", "{ value = \"1 Pa\" }\nband", {"check[0].reference.source"}),
        bad_case("reference_nan", "{ solution = \"linear_displacement\" }\nband", "{ value = \"nan Pa\", source = \"me\" }\nband", {"check[0].reference.value"}),
        bad_case("point_outside_the_body", "[\"0.5 m\", \"0.5 m\", \"0.5 m\"]", "[\"5 m\", \"0.5 m\", \"0.5 m\"]", {"at: expected points in the body", "(5, 0.5, 0.5)"}),
        bad_text("crack_wider_than_the_body", changed(good_penny, "\"1 m\"\n[material]", "\"9 m\"\n[material]"), {"bad.toml", "geometry.half_width", "crack radii"}),
        bad_text("crack_of_no_size", changed(good_penny, "\"1 m\"\n[material]", "\"0 m\"\n[material]"), {"bad.toml", "crack_radius", "positive"}),
        bad_case("material_unknown", engineering, "name = \"unobtainium\"", {"material", "unobtainium"}),
        bad_case("material_missing", engineering, "", {"material"}),
        bad_case("material_two_ways", engineering, engineering + "\nname = \"silicon\"\ncubic = { C11 = \"1 GPa\", C12 = \"0 GPa\", C44 = \"1 GPa\" }", {"material"}),
        bad_stiffness("poisson_half", "engineering = { E = \"1 GPa\", nu = 0.5 }", {"nu"}),
        bad_stiffness("poisson_minus_one", "engineering = { E = \"1 GPa\", nu = -1.0 }", {"nu"}),
        bad_stiffness("young_zero", "engineering = { E = \"0 GPa\", nu = 0.2 }", {"E"}),
        bad_stiffness("young_nan", "engineering = { E = \"nan GPa\", nu = 0.2 }", {"E"}),
        bad_stiffness("cubic_unstable", "cubic = { C11 = \"1 GPa\", C12 = \"2 GPa\", C44 = \"1 GPa\" }", {"positive definite"}),
        bad_stiffness("stiffness_five_rows", stiff + "[[1,0,0,0,0,0],[0,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0]] }", {"voigt"}),
        bad_stiffness("stiffness_not_symmetric", stiff + "[[2,1,0,0,0,0],[0,2,0,0,0,0],[0,0,2,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]] }", {"symmetric"}),
        bad_stiffness("stiffness_indefinite", stiff + "[[1,2,0,0,0,0],[2,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]] }",
                      {"positive definite"}),
        bad_stiffness("stiffness_nan", stiff + "[[nan,0,0,0,0,0],[0,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]] }", {"voigt"}),
        bad_stiffness("stiffness_unit_is_a_length", "stiffness = { unit = \"m\", voigt = [[1,0,0,0,0,0],[0,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]] }",
                      {"unit"}),
        bad_stiffness("twenty_numbers", "stiffness = { unit = \"GPa\", voigt = [1,0,0,0,0,0,1,0,0,0,0,1,0,0,0,1,0,0,1,0] }", {"voigt"}),
        bad_stiffness("density_negative", "engineering = { E = \"1 GPa\", nu = 0.2 }\ndensity = \"-1 kg/m^3\"", {"density"}),
        bad_stiffness("rotation_about_nothing", "engineering = { E = \"1 GPa\", nu = 0.2 }\nrotation = { axis = [0, 0, 0], angle = \"30 deg\" }", {"rotation"}),
        bad_stiffness("rotation_by_a_length", "engineering = { E = \"1 GPa\", nu = 0.2 }\nrotation = { axis = [0, 0, 1], angle = \"30 m\" }", {"rotation"}),
        bad_stiffness("material_unknown_key", "engineering = { E = \"1 GPa\", nu = 0.2 }\ncolour = \"red\"", {"colour"}),
        bad_stiffness("material_empty", "", {"expected"}),
        bad_table("table_missing", {}, {"material_sweep.toml", "study.csv", "table.csv"}),
        bad_table("table_is_a_folder", {{"table.csv/file", "x"}}, {"table.csv"}),
        bad_table("table_empty", {{"table.csv", ""}}, {"table.csv", "21 constants"}),
        bad_table("table_binary", {{"table.csv", std::string("\x7f" "ELF\x02\0\n\0\xff", 9)}}, {"table.csv"}),
        bad_table("table_twenty_numbers", {{"table.csv", table_row.substr(2) + "\n"}}, {"table.csv:1", "21 numbers", "(not 20)"}),
        bad_table("table_nan", {{"table.csv", "C11\n\nsoft," + changed(table_row, "9,", "nan,") + "\n"}}, {"table.csv:3", "finite number", "nan"}),
        bad_table("table_unstable", {{"table.csv", table_row + "\n" + changed(table_row, "9,", "-9,") + "\n"}}, {"table.csv:2", "positive definite"}),
        {"validate_override_without_value", "validate good.toml --set geometry.extent --out out", {{"good.toml", good_case}}, {"--set"}},
        {"validate_override_of_nothing", "validate good.toml --set geometry.width=1 --out out", {{"good.toml", good_case}}, {"width"}},
        {"validate_level_unknown", "validate good.toml --level huge --out out", {{"good.toml", good_case}}, {"--level"}},
        {"validate_ladder_of_words", "validate good.toml --ladder a,b --out out", {{"good.toml", good_case}}, {"--ladder"}},
        {"validate_shard_0", "validate good.toml --shard 0/3 --out out", {{"good.toml", good_case}}, {"--shard"}},
        {"validate_compared_with_nothing", "validate good.toml --compare none.json --out out", {{"good.toml", good_case}}, {"none.json"}},
        {"validate_out_is_a_file", "validate good.toml --out taken", {{"good.toml", good_case}, {"taken", "a file"}}, {"taken"}, 3},
        {"validate_unwritable", "validate good.toml --out /proc/cleave", {{"good.toml", good_case}}, {"/proc"}, 3},
    };
}

class BadCase : public testing::TestWithParam<BadInput> {};

TEST_P(BadCase, GetsOneLine) { EXPECT_EQ(complaint(GetParam()), ""); }

INSTANTIATE_TEST_SUITE_P(Cases, BadCase, testing::ValuesIn(bad_cases()), [](const auto& info) { return info.param.name; });

// Twins: the table's judge sees a good input, a wrong code, a line that lacks the key, and a file that is left.
TEST(BadInputs, AnInputThatIsGoodIsNotTakenForBad) {
    const BadInput good{"good", "validate good.toml --out out", {{"good.toml", good_case}}, {"nothing of this"}};
    const std::string said = complaint(good);
    for (const char* part : {"exit code 0 instead of 2", "no 'nothing of this'", "something on stdout", "it left out/results.json"})
        EXPECT_NE(said.find(part), std::string::npos) << part << " is not in: " << said;
}

}  // namespace
}  // namespace cleave::robustness
