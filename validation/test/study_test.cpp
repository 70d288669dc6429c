#include "validation/study.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "validation/results_json.hpp"
#include "validation/runner.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cleave::validation {
namespace {

/// A study whose numbers are known: "length" 2 m by "rule" at two places, 2.02 m and 1.98 m by "tape" at the first; an angle of 30 degrees;
/// a "width" of the worst of two planks.
class Ruler final : public Study {
public:
    StudyOutcome run(const StudyContext&) const override {
        StudyOutcome outcome;
        for (const char* place : {"left", "right"}) outcome.values.push_back({"length", "rule", place, 2});
        outcome.values.push_back({"length", "tape", "left", 2.02, {0.2, 10, 0}});
        outcome.values.push_back({"length", "tape", "left", 1.98, {0.1, 80, 0}});
        outcome.values.push_back({"slope", "rule", "", std::numbers::pi / 6});
        outcome.values.push_back({"width", "rule", "left", 3, {}, "worst of 2: plank"});
        return outcome;
    }
};

Case case_with(const Check& check) {
    Case one;
    one.file = "ruler.toml";
    one.name = "ruler";
    one.tier = "verification";
    one.study = std::make_shared<Ruler>();
    one.checks = {check};
    return one;
}

Check length_check() {
    Check check;
    check.observable.quantity = "length";
    check.unit = dimension::length;
    check.where = "check[0]";
    return check;
}

const std::string good = R"(name = "kernel"
tier = "verification"
about = "a study for the tests"
[study]
name = "kernel_properties"
[[check]]
quantity = "kernel_integral"
place = "aspect 4"
solver = ["solver"]
reference = { value = 1, source = "unity" }
band = { relative = 1e-9 }
basis = "quadrature"
)";

std::vector<Case> read(const std::string& text) {
    const ScratchFolder folder;
    const auto file = folder / "study.toml";
    write_file_atomic(file, text);
    return read_cases(file, {});
}

std::string replaced(const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

template <class Call>
std::string error_of(const Call& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Study, ChecksAreReadAndRun) {
    const std::vector<Case> cases = read(good);
    ASSERT_EQ(cases.size(), 1U);
    const CaseRun run = run_case(cases[0], {});
    ASSERT_EQ(run.result.rows.size(), 1U);
    EXPECT_EQ(run.result.rows[0].place, "aspect 4");
    EXPECT_NEAR(*run.result.rows[0].measurement.value, 1, 1e-9);
    EXPECT_EQ(run.result.verdict, Verdict::pass);
}

// The must-fail twin: another reference misses the band.
TEST(Study, AWrongReferenceFails) {
    EXPECT_EQ(run_case(read(replaced("value = 1,", "value = 1.001,"))[0], {}).result.verdict, Verdict::fail);
}

TEST(Study, MistakesAreNamed) {
    struct Row { std::string text, expected; };
    const std::vector<Row> rows{
        {replaced("\"kernel_properties\"", "\"kernel_propreties\""), "study.name: expected one of "},
        {replaced("[study]\n", "[study]\nsize = 3\n"), "study.size: expected a known key"},
        {replaced("\"kernel_integral\"", "\"kernel\""), "check[0].quantity: expected one of kernel_integral"},
        {replaced("[\"solver\"]", "[\"fem.p2\"]"), "check[0].solver: expected one of solver, paper (not 'fem.p2')"},
        {replaced("value = 1, source = \"unity\"", "solution = \"laminate\""), "check[0].reference: expected exactly one of value, solver"},
        {replaced("relative = 1e-9", "order_at_least = 2"), "check[0].band: expected no order_at_least in a study"},
        {replaced("basis = \"quadrature\"", ""), "check[0].basis"},
        {good + "[geometry]\nshape = \"block\"\n", "geometry: expected a known key"}};
    for (const Row& row : rows) {
        const std::string error = error_of([&] { (void)read(row.text); });
        EXPECT_NE(error.find(row.expected), std::string::npos) << "expected: " << row.expected << "\n  got: " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
    EXPECT_NE(error_of([] { run_case(read(replaced("aspect 4", "aspect 5"))[0], {}); }).find("check[0].place: expected one of aspect 1"),
              std::string::npos);
}

TEST(Study, RowsFollowSolversAndPlaces) {
    Check check = length_check();
    check.solvers = {"rule", "tape"};
    const CaseRun run = run_case(case_with(check), {});
    ASSERT_EQ(run.result.rows.size(), 3U);
    EXPECT_EQ(run.result.rows[1].place, "right");
    EXPECT_EQ(run.result.rows[2].solver, "tape");
    EXPECT_EQ(run.result.verdict, Verdict::info);
}

TEST(Study, AnotherMethodIsTheReferenceAtTheSamePlace) {
    Check check = length_check();
    check.solvers = {"tape"};
    check.reference.kind = Reference::Kind::solver;
    check.reference.source = "rule";
    check.bands[""].relative = 0.011;
    const Row row = run_case(case_with(check), {}).result.rows.at(0);
    EXPECT_NEAR(row.measurement.relative_error, 0.01, 1e-12);
    ASSERT_EQ(row.ladder.size(), 2U);
    EXPECT_NEAR(row.ladder[0].error, 0.01, 1e-12);
    EXPECT_EQ(row.resolution.particles, 80);
    EXPECT_EQ(row.verdict, Verdict::pass);

    check.solvers = {"rule"};
    check.reference.source = "tape";  // knows the left place only
    EXPECT_NE(error_of([&] { run_case(case_with(check), {}); }).find("reference.solver: expected a method with a value of length at 'right'"),
              std::string::npos);
}

TEST(Study, ADetailStandsBesideThePlaceAndIsKept) {
    Check check = length_check();
    check.observable.quantity = "width";
    check.solvers = {"rule"};
    check.places = {"left"};  // the place alone is what a check names
    const CaseResult result = run_case(case_with(check), {}).result;
    const Row row = case_of(case_json(result)).rows.at(0);
    EXPECT_EQ(row.place, "left");
    EXPECT_EQ(row.detail, "worst of 2: plank");
    EXPECT_EQ(place_text(row), "left (worst of 2: plank)");
    EXPECT_NE(results_csv({result}).find(",left (worst of 2: plank),"), std::string::npos);
    check.observable.quantity = "length";
    const CaseResult plain = run_case(case_with(check), {}).result;
    EXPECT_FALSE(case_json(plain)["checks"][0].contains("detail"));
    EXPECT_EQ(place_text(case_of(case_json(plain)).rows.at(0)), "left");
}

TEST(Study, AnglesAreShownInDegrees) {
    Check check = length_check();
    check.observable.quantity = "slope";
    check.unit = dimension::none;
    check.angle = true;
    check.solvers = {"rule"};
    const Row row = run_case(case_with(check), {}).result.rows.at(0);
    EXPECT_NEAR(*row.measurement.value, 30, 1e-12);
    EXPECT_EQ(row.unit, "deg");
}

}  // namespace
}  // namespace cleave::validation
