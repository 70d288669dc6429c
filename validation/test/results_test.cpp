#include "validation/results.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace cleave::validation {
namespace {

std::vector<CaseResult> sample(double error) {
    Row row;
    row.case_name = "a<b";
    row.tier = "verification";
    row.quantity = "stress";
    row.unit = "Pa";
    row.place = "rms over 1 < r/a < 3";
    row.solver = "fem.p2";
    row.resolution = {0.1, 100, 300};
    row.measurement = {1.0, 1.0 + error, error, error, std::nullopt};
    row.reference_source = "a \"quoted\", source";
    row.band.relative = 0.01;
    row.basis = "why";
    row.ladder = {{row.resolution, error}};
    row.verdict = judge(row.measurement, row.band, false);
    Row broken = row;
    broken.measurement.relative_error = std::nan("");
    broken.verdict = judge(broken.measurement, broken.band, false);
    broken.solver = "fem.p1";
    Row info = row;
    info.band = {};
    info.verdict = Verdict::info;
    info.solver = "sph.paper";
    return {{"a<b", "verification", "about", "cleave validate a", {{"k", "v"}}, {row, broken, info}, Verdict::fail}};
}

TEST(Results, CountsAndNumbersSurviveTheRoundTrip) {
    const auto json = nlohmann::json::parse(results_json(sample(0.005), "quick"));
    EXPECT_EQ(json["schema"], "cleave.results/1");
    EXPECT_EQ(json["counts"], (nlohmann::json{{"pass", 1}, {"fail", 1}, {"info", 1}}));
    const auto& checks = json["cases"][0]["checks"];
    EXPECT_EQ(checks[0]["error"].get<double>(), 0.005);
    EXPECT_EQ(checks[0]["verdict"], "pass");
    EXPECT_TRUE(checks[1]["error"].is_null()) << "NaN is null";
    EXPECT_EQ(checks[1]["verdict"], "fail");
    EXPECT_TRUE(checks[2]["band"].is_null());
    EXPECT_EQ(results_json(sample(0.005), "quick"), results_json(sample(0.005), "quick"));
}

TEST(Results, JunitCountsFailuresAndEscapes) {
    const std::string xml = junit_xml(sample(0.005));
    EXPECT_NE(xml.find("tests=\"2\" failures=\"1\""), std::string::npos) << xml;
    EXPECT_NE(xml.find("a&lt;b"), std::string::npos);
    EXPECT_EQ(xml.find("a<b"), std::string::npos);
}

TEST(Results, CsvQuotesCells) {
    const std::string csv = results_csv(sample(0.005));
    EXPECT_NE(csv.find("\"a \"\"quoted\"\", source\""), std::string::npos) << csv;
}

TEST(Results, DriftIsToldAndSamenessToo) {
    const ScratchFolder folder;
    const std::string file = (folder / "old_results.json").string();
    write_file_atomic(file, results_json(sample(0.005), "quick"));
    EXPECT_EQ(drift(sample(0.005), file), "3 rows unchanged\n");
    const std::string changed = drift(sample(0.02), file);
    EXPECT_NE(changed.find("drifted"), std::string::npos) << changed;
    EXPECT_NE(changed.find("pass -> fail"), std::string::npos) << changed;
    EXPECT_NE(drift({}, file).find("vanished"), std::string::npos);
    write_file_atomic(file, "{}");
    EXPECT_THROW(drift({}, file), InputError);
}

}  // namespace
}  // namespace cleave::validation
