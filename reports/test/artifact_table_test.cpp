#include "reports/artifact_table.hpp"

#include "solver/input/input_error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using cleave::reports::max_artifact_rows;
using cleave::reports::parse_artifact;
using cleave::reports::read_artifact;
using nlohmann::json;

TEST(ArtifactTable, ReadsNamesNumbersAndGaps) {
    const json table = parse_artifact("# samples\nx, reference,\"fem.p2\"\r\n0,1.5,nan\n\n2e-3,,-4\n");
    EXPECT_EQ(table["columns"], json({"x", "reference", "fem.p2"}));
    EXPECT_EQ(table["rows"], json::parse("[[0.0,1.5,null],[0.002,null,-4.0]]"));
    EXPECT_EQ(table["total"], 2);
}

TEST(ArtifactTable, SaysWhatIsWrongInsteadOfDrawingIt) {
    EXPECT_EQ(parse_artifact("x,y\n1,2\n3,four\n")["note"], "line 3: expected a number");
    EXPECT_EQ(parse_artifact("x,y\n1,2,3\n")["note"], "line 2: expected 2 cells");
    EXPECT_EQ(parse_artifact("x,y\n")["note"], "no rows");
    EXPECT_EQ(parse_artifact("")["note"], "expected a first row with two or more names");
}

TEST(ArtifactTable, ThinsLongTablesEvenlyAndKeepsBothEnds) {
    std::string text = "x,y\n";
    for (int i = 0; i <= 10000; ++i) text += fmt::format("{},{}\n", i, i);
    const json table = parse_artifact(text);
    ASSERT_EQ(table["rows"].size(), max_artifact_rows);
    EXPECT_EQ(table["total"], 10001);
    EXPECT_EQ(table["rows"].front()[0], 0.0);
    EXPECT_EQ(table["rows"].back()[0], 10000.0);
    for (std::size_t i = 1; i < max_artifact_rows; ++i) {
        const double step = table["rows"][i][0].get<double>() - table["rows"][i - 1][0].get<double>();
        EXPECT_TRUE(step == 5 || step == 6) << i;  // 10000 / 1999 = 5.0025
    }
}

TEST(ArtifactTable, NeverReadsOutsideTheFolder) {
    for (const char* file : {"../secret.csv", "/etc/passwd", "a/../../b.csv", ""}) {
        EXPECT_THROW(read_artifact("folder", file, "results.json"), cleave::InputError) << file;
    }
    EXPECT_EQ(read_artifact("folder", "a/../missing.csv", "results.json")["note"], "the file is not in the results folder");
    EXPECT_EQ(read_artifact("folder", "field.vtu", "results.json")["note"], "not a table");
}

}  // namespace
