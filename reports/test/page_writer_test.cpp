#include "reports/page_writer.hpp"

#include "reports/history.hpp"
#include "reports/report_data.hpp"
#include "reports/summary.hpp"
#include "solver/input/input_error.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace {

using namespace cleave::reports;
using nlohmann::json;

json embedded(const std::string& page) {
    const std::string open = R"(<script type="application/json" id="report-data">)";
    const std::size_t begin = page.find(open) + open.size();
    return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
    return found;
}

TEST(PageWriter, EmbedsTheResultsUnchanged) {
    const Report report = load_report({CLEAVE_SAMPLE});
    const json data = embedded(render_page(report));
    EXPECT_EQ(data["sources"][0]["results"], report.sources[0].results);
    EXPECT_EQ(data["sources"][0]["bench"], report.sources[0].bench);
    EXPECT_EQ(data["sources"][0]["artifacts"]["hole_sample/ligament.csv"]["columns"][1], "reference");
}

TEST(PageWriter, DataCannotEndItsScriptElement) {
    Report report = load_report({CLEAVE_SAMPLE});
    const int scripts = count(render_page(report), "</script");
    const std::string attack = "</script><script>alert(1)</script><!--";
    report.sources[0].results["cases"][0]["about"] = attack;
    const std::string page = render_page(report);
    EXPECT_EQ(count(page, "</script"), scripts);
    EXPECT_EQ(embedded(page)["sources"][0]["results"]["cases"][0]["about"], attack);
}

TEST(PageWriter, UnescapedDataWouldEndIt) {  // the twin: plain JSON does hold the closing tag
    EXPECT_NE(json("</script>").dump().find("</script"), std::string::npos);
    EXPECT_EQ(embeddable_json("</script>").find('<'), std::string::npos);
}

TEST(PageWriter, ScriptsCannotEndTheirElement) {
    EXPECT_EQ(embeddable_script("a('</script>'); b('<!-- c')"), "a('<\\/script>'); b('<\\!-- c')");
}

TEST(PageWriter, TemplateIsFilledInOnePass) {
    EXPECT_EQ(fill_template("<{{a}}|{{b}}>", {{"a", "{{b}}"}, {"b", "x"}}), "<{{b}}|x>");
    EXPECT_THROW(fill_template("{{c}}", {{"a", ""}}), std::logic_error);
}

TEST(PageWriter, SameResultsSameBytes) {
    EXPECT_EQ(render_page(load_report({CLEAVE_SAMPLE})), render_page(load_report({CLEAVE_SAMPLE})));
}

TEST(PageWriter, LoadsNothingFromElsewhere) {
    const std::string page = render_page(load_report({CLEAVE_SAMPLE}));
    const std::regex loads(R"(<(link|img|iframe|script)[^>]*(src|href)=|@import|url\(\s*["']?https?:)");
    EXPECT_FALSE(std::regex_search(page.substr(0, page.find("report-data")), loads));
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST(PageWriter, RejectsTextThatIsNotUtf8) { EXPECT_THROW(embeddable_json(json("\xff")), cleave::InputError); }

TEST(ReportData, RejectsTheSameCaseFromTwoFolders) { EXPECT_THROW(load_report({CLEAVE_SAMPLE, CLEAVE_SAMPLE}), cleave::InputError); }

TEST(ReportData, MergesFoldersWithDifferentCases) {
    const Report report = load_report({CLEAVE_SAMPLE, CLEAVE_SAMPLE "_empty"});
    ASSERT_EQ(report.sources.size(), 2u);
    EXPECT_TRUE(report.sources[1].bench.is_null());
}

TEST(Summary, ListsEveryCheckOnceAndTheMissedFirst) {
    const std::string text = render_summary(load_report({CLEAVE_SAMPLE}));
    EXPECT_NE(text.find("11 of 12 judged checks passed; 2 for information."), std::string::npos);
    const std::size_t all = text.find("## All checks");
    ASSERT_NE(all, std::string::npos);
    EXPECT_LT(text.find("## Missed"), all);
    EXPECT_EQ(count(text.substr(all), "\n| "), 1 + 14);  // head and fourteen checks
}

TEST(Summary, FitsIntoACommentAndCountsWhatDoesNot) {
    Report report = load_report({CLEAVE_SAMPLE});
    json& checks = report.sources[0].results["cases"][0]["checks"];
    for (int i = 0; i < 2000; ++i) checks.push_back(checks[0]);
    const std::string text = render_summary(report);
    EXPECT_LT(text.size(), 65536u);
    EXPECT_NE(text.find("more stand in results.csv"), std::string::npos);
    EXPECT_NE(text.find("worst judged energy release rate | 4.5 %"), std::string::npos) << text.substr(0, 800);
    EXPECT_NE(text.find("only recorded (sph.paper: sample: the printed operator has no band) | 28 %"), std::string::npos) << text.substr(0, 800);
}

TEST(History, TellsWhatChanged) {
    Report report = load_report({CLEAVE_SAMPLE});
    EXPECT_TRUE(read_history({}, report).is_null());
    EXPECT_TRUE(read_history({CLEAVE_SAMPLE}, report)["changes"].empty()) << "the same run";
    json& checks = report.sources[0].results["cases"][0]["checks"];
    checks[0]["error"] = 0.5;
    checks[0]["verdict"] = "fail";
    json another = checks[0];
    another["place"] = "elsewhere";
    checks.push_back(another);
    report.history = read_history({CLEAVE_SAMPLE}, report);
    ASSERT_EQ(report.history["changes"].size(), 2u);
    ASSERT_EQ(report.history["runs"].size(), 2u);
    EXPECT_EQ(report.history["runs"][1]["counts"]["fail"], report.history["runs"][0]["counts"]["fail"].get<int>() + 2);
    EXPECT_NE(render_summary(report).find("| drifted | patch_sample |"), std::string::npos);
    EXPECT_NE(render_summary(report).find("| new | patch_sample |"), std::string::npos);
    report.sources[0].results["cases"].erase(0);
    EXPECT_EQ(read_history({CLEAVE_SAMPLE}, report)["changes"][0]["kind"], "vanished");
}

}  // namespace
