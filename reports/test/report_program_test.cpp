#include "solver/input/file_io.hpp"
#include "solver/input/test/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace {

namespace fs = std::filesystem;

/// Runs the program itself: exit codes and what is left on disk are its contract with the launcher.
class ReportProgram : public testing::Test {
protected:
    int run(const std::string& arguments) const {
        const std::string command = std::string(CLEAVE_REPORT_PROGRAM) + " " + arguments + " >" + in("stdout") + " 2>" + in("stderr");
        return WEXITSTATUS(std::system(command.c_str()));
    }
    int run_on(const std::string& results_text) const {
        cleave::write_file_atomic(in("from/results.json"), results_text);
        return run("--from " + in("from") + " --out " + in("out"));
    }
    std::string in(const std::string& name) const { return (folder_ / name).string(); }
    std::string message() const { return cleave::read_file(in("stderr")); }
    bool wrote_nothing() const { return !fs::exists(in("out")) || fs::is_empty(in("out")); }

    cleave::ScratchFolder folder_;
};

TEST_F(ReportProgram, WritesPageAndSummary) {
    EXPECT_EQ(run("--from " CLEAVE_SAMPLE " --out " + in("out")), 0) << message();
    EXPECT_NE(cleave::read_file(in("out/index.html")).find("hole_sample"), std::string::npos);
    EXPECT_NE(cleave::read_file(in("out/summary.md")).find("hole_sample"), std::string::npos);
}

TEST_F(ReportProgram, MissedBandsAreNotItsBusiness) {  // the sample holds a missed band
    EXPECT_NE(cleave::read_file(CLEAVE_SAMPLE "/results.json").find("\"verdict\": \"fail\""), std::string::npos);
    EXPECT_EQ(run("--from " CLEAVE_SAMPLE " --out " + in("out")), 0);
}

TEST_F(ReportProgram, MissingResultsExitTwoInOneLine) {
    EXPECT_EQ(run("--from " + in("nowhere") + " --out " + in("out")), 2);
    EXPECT_NE(message().find("nowhere/results.json"), std::string::npos);
    const std::string text = message();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_TRUE(wrote_nothing());
}

TEST_F(ReportProgram, BrokenJsonNamesTheLine) {
    EXPECT_EQ(run_on("{\n\"schema\": \"cleave.results/1\",\n\"cases\": [}\n"), 2);
    EXPECT_NE(message().find("results.json:3"), std::string::npos) << message();
    EXPECT_TRUE(wrote_nothing());
}

TEST_F(ReportProgram, AnotherSchemaIsRefused) {
    EXPECT_EQ(run_on(R"({"schema": "cleave.results/2", "cases": []})"), 2);
    EXPECT_NE(message().find("schema"), std::string::npos);
    EXPECT_TRUE(wrote_nothing());
}

TEST_F(ReportProgram, BrokenCompanionIsRefused) {
    cleave::write_file_atomic(in("from/bench.json"), "[");
    EXPECT_EQ(run_on(R"({"schema": "cleave.results/1", "cases": []})"), 2);
    EXPECT_NE(message().find("bench.json"), std::string::npos);
    EXPECT_TRUE(wrote_nothing());
}

TEST_F(ReportProgram, AnUnwritableFolderIsTheEnvironmentsFault) {
    cleave::write_file_atomic(in("file"), "");
    EXPECT_EQ(run("--from " CLEAVE_SAMPLE " --out " + in("file")), 3) << message();
}

TEST_F(ReportProgram, WrongArgumentsExitTwo) {
    EXPECT_EQ(run("--from"), 2);
    EXPECT_EQ(run("--form x --out y"), 2);
    EXPECT_EQ(run("--help"), 0);
}

}  // namespace
