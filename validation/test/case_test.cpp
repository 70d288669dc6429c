#include "validation/case.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "validation/runner.hpp"
#include "validation/suite.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace cleave::validation {
namespace {

const std::string good = R"(name = "small"
tier = "verification"
about = "a case for the tests"
[geometry]
shape = "block"
extent = ["2 m", "1 m", "1 m"]
[material]
engineering = { E = "70 GPa", nu = 0.25 }
[load]
displacement = [{ on = "all", solution = "linear_displacement" }]
[particles]
solution = "linear_displacement"
[ladder]
relative_to = "extent"
quick = [0.5, 0.25]
[[check]]
quantity = "stress"
solver = ["fem.p2", "sph.corrected"]
reference = { solution = "linear_displacement" }
over = { region = "depth > 0.1", norm = "max" }
band = { "fem.p2" = { relative = 1e-10 }, "sph.corrected" = { relative = 1e-9 } }
basis = "exact"
)";

const ScratchFolder scratch;

std::string write(const std::string& text) {
    const std::string file = (scratch / "case.toml").string();
    write_file_atomic(file, text);
    return file;
}

std::string replaced(const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string error_of(const std::string& text, const Overrides& overrides = {}) {
    try {
        (void)read_cases(write(text), overrides);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Case, ReadsGeometryLoadsLadderAndChecksInSi) {
    const std::vector<Case> cases = read_cases(write(good), {});
    ASSERT_EQ(cases.size(), 1U);
    const Case& one = cases[0];
    EXPECT_EQ(one.sizes("full"), (std::vector<double>{1.0, 0.5}));  // 2 m times 0.5, 0.25; quick stands in for full
    ASSERT_EQ(one.checks.size(), 1U);
    EXPECT_DOUBLE_EQ(*one.checks[0].band("sph.corrected").relative, 1e-9);
    EXPECT_EQ(one.checks[0].norm, "max");
    EXPECT_NEAR(one.materials.at("").stiffness(3, 3), 28e9, 1);  // G = E / (2 (1 + nu))
}

TEST(Case, ALadderRelativeToAShortLengthIsReadAsItStands) {
    const std::vector<Case> cases = read_cases(write(replaced("[\"2 m\", \"1 m\", \"1 m\"]", "[\"2 mm\", \"1 mm\", \"1 mm\"]")), {});
    EXPECT_EQ(cases[0].sizes("quick"), (std::vector<double>{1e-3, 0.5e-3}));
}

// Each mistake: one line that names the file, the key and what was expected.
TEST(Case, MistakesAreNamed) {
    struct Row { std::string text, expected; };
    const std::vector<Row> rows{
        {replaced("quick =", "qiuck ="), "ladder.quick: expected an array of sizes"},
        {replaced("norm = \"max\"", "norm = \"max\", nrom = 1"), "check[0].over.nrom: expected a known key; did you mean 'norm'?"},
        {replaced("\"block\"", "\"blob\""), "geometry.shape: expected one of block, "},
        {replaced("\"2 m\"", "\"2 kg\""), "geometry.extent: expected a quantity with a unit like '1 m' (not kg)"},
        {replaced("\"2 m\"", "\"-2 m\""), "geometry.extent: expected three positive lengths"},
        {replaced("on = \"all\"", "on = \"lid\""), "load.displacement[0].on: expected one of all, left, right"},
        {replaced("relative = 1e-10", "relative = -1"), "relative: expected a positive number"},
        {replaced("relative = 1e-10", "side = \"beneath\""), "side: expected one of below, above"},
        {replaced("relative = 1e-10", "side = \"below\""), "check[0].band: expected no side for a field"},
        {replaced("[0.5, 0.25]", "[0.25, 0.5]"), "ladder.quick: expected sizes from coarse to fine"},
        {replaced("\"fem.p2\", \"sph.corrected\"]", "\"fem.p9\"]"), "check[0].solver: expected one of fem.p1"},
        {replaced("\"stress\"", "\"stres\""), "check[0].quantity: expected one of displacement, strain, stress, energy"},
        {replaced("basis = \"exact\"", "basis = \"exact\"\nat_size = -1"), "check[0].at_size: expected a positive size"},
        {replaced("basis = \"exact\"", ""), "check[0].basis: expected why the band is that wide"},
        {replaced("depth > 0.1", "dept > 0.1"), "check[0].over.region: expected a number or one of depth, size, x, y, z (not 'dept')"},
        {replaced("{ solution = \"linear_displacement\" }\nover", "{ value = 3.0, source = \"me\" }\nover"), "check[0].reference.value"},
        {replaced("solution = \"linear_displacement\"\n[ladder]", "solution = \"linear_displacement\"\nkernel = { axis = [0, 0, 0] }\n[ladder]"),
         "particles.kernel.axis: expected three numbers, not all zero"},
        {replaced("nu = 0.25", "nu = 0.7"), "material"},
        {"name = 3\n", "name: expected a string"},
        {"", "name: expected a string (the key is missing)"}};
    for (const Row& row : rows) {
        const std::string error = error_of(row.text);
        EXPECT_NE(error.find(row.expected), std::string::npos) << "expected: " << row.expected << "\n  got: " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        EXPECT_NE(error.find("case.toml"), std::string::npos) << error;
    }
}

TEST(Case, SweepsExpandToEveryCombination) {
    const std::vector<Case> cases = read_cases(write(good + "[sweep]\n\"material.engineering.E\" = [\"70 GPa\", \"140 GPa\"]\n\"about\" = [\"a\", \"b\", \"c\"]\n"), {});
    ASSERT_EQ(cases.size(), 6U);
    EXPECT_EQ(cases[0].parameters.at("about"), "a");
    EXPECT_NE(cases[0].name, cases[1].name);
    int stiff = 0;
    for (const Case& one : cases) stiff += one.materials.at("").stiffness(3, 3) > 50e9;
    EXPECT_EQ(stiff, 3);
}

TEST(Case, OverridesAndLaddersComeFromTheCommandLine) {
    const std::vector<Case> cases = read_cases(write(good), {{{"material.engineering.E", "140 GPa"}}, "0.3,0.2"});
    EXPECT_NEAR(cases[0].materials.at("").stiffness(3, 3), 56e9, 1);
    EXPECT_EQ(cases[0].sizes("quick").size(), 2U);
    EXPECT_DOUBLE_EQ(cases[0].sizes("quick")[1], 0.4);
    EXPECT_NE(error_of(good, {{{"materail.E", "1"}}, ""}).find("materail.E"), std::string::npos);
    EXPECT_NE(error_of(good, {{}, "0.3,x"}).find("--ladder"), std::string::npos);
}

TEST(Case, ACheckForOneSizeEndsItsLadderThere) {
    const std::string text = replaced("basis = \"exact\"", "basis = \"exact\"\nat_size = 0.5");
    const Check check = read_cases(write(text), {})[0].checks[0];
    EXPECT_DOUBLE_EQ(*check.at_size, 1.0);  // in the ladder's unit, 2 m
    const std::vector<double> ladder{2, 1, 0.5}, without{2, 0.5};
    EXPECT_TRUE(check.takes(2, ladder) && check.takes(1, ladder));
    EXPECT_FALSE(check.takes(0.5, ladder));
    EXPECT_FALSE(check.takes(2, without)) << "a ladder without the size has no such check";
    EXPECT_TRUE(read_cases(write(good), {})[0].checks[0].takes(0.5, ladder));
}

TEST(Case, OnGradedMeshesOnlyQuantitiesOfTheFrontHaveAnOrder) {
    std::ifstream file(case_folder() / "fracture_corner.toml");
    std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(error_of(text), "no error");
    const std::string band = "band = { relative = 0.2 }";
    text.replace(text.find(band), band.size(), "band = { order_at_least = 0.5 }");
    EXPECT_NE(error_of(text).find("check[0].band: expected no order_at_least for a shape whose mesh is graded"), std::string::npos) << error_of(text);
}

TEST(Runner, ACheckForOneSizeIsJudgedThere) {
    RunOptions options;
    options.out = scratch / "runner";
    const std::string particles_only = replaced("\"fem.p2\", \"sph.corrected\"]", "\"sph.corrected\"]");
    const auto run = [&](const std::string& more) {
        std::string text = particles_only;
        text.replace(text.find("\"fem.p2\" = { relative = 1e-10 }, "), 33, "");
        return run_case(read_cases(write(text + more), {})[0], options).result.rows;
    };
    const std::vector<Row> all = run(""), coarse = run("at_size = 0.5\n");
    ASSERT_EQ(all.size(), 1U);
    ASSERT_EQ(coarse.size(), 1U);
    EXPECT_EQ(all[0].ladder.size(), 2U);
    EXPECT_EQ(coarse[0].ladder.size(), 1U);
    EXPECT_EQ(coarse[0].resolution.particles, all[0].ladder[0].resolution.particles);
    EXPECT_TRUE(run("at_size = 0.3\n").empty());
}

TEST(Suite, EveryShippedCaseReadsAndHasABandAndATwin) {
    for (const auto& file : shipped_case_files())
        for (const Case& one : read_cases(file.string(), {})) {
            EXPECT_EQ(one.name.substr(0, one.name.find('[')), file.stem().string());
            bool judged = false, twin = false;
            for (const Check& check : one.checks) {
                judged = judged || (!check.bands.empty() && !check.must_fail);
                twin = twin || check.must_fail;
            }
            EXPECT_TRUE(judged) << file << " judges nothing";
            EXPECT_TRUE(twin) << file << " has no must-fail twin";
        }
}

TEST(Suite, NamesGlobsAndShardsSelect) {
    EXPECT_EQ(select_files({"hole_*"}).size(), 1U);
    EXPECT_EQ(select_files({"*_triclinic", "patch_triclinic"}).size(), 2U);
    EXPECT_THROW(select_files({"no_such_case"}), InputError);
    const std::vector<Case> all = read_cases(write(good + "[sweep]\nabout = [\"a\", \"b\", \"c\", \"d\", \"e\"]\n"), {});
    EXPECT_EQ(shard(all, "1/2").size() + shard(all, "2/2").size(), 5U);
    for (const char* text : {"0/2", "3/2", "1", "a/b", "1/2x", ""}) EXPECT_THROW(shard(all, text), InputError) << text;
}

}  // namespace
}  // namespace cleave::validation
