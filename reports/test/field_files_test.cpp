#include "reports/field_files.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace {

using namespace cleave::reports;
using nlohmann::json;

/// One point: 6, 2, 12 and 12 bytes, 8, 4, 16 and 16 letters of base64.
json field() {
    const auto packed = [](std::size_t letters) { return json{{"scale", 1.5}, {"data", std::string(letters, 'A')}}; };
    return {{"schema", "cleave.stress_field/1"}, {"shown", 1}, {"measures", json::array({json{{"name", "xx"}}})},
            {"position", packed(8)}, {"radius", packed(4)}, {"stress", packed(16)}, {"difference", packed(16)}};
}

class FieldFiles : public testing::Test {
protected:
    json results(const std::vector<std::string>& files) const {
        json artifacts = json::array();
        for (const std::string& file : files) artifacts.push_back({{"file", file}});
        return {{"cases", json::array({json{{"checks", json::array({json{{"artifacts", artifacts}}, json::object()})}}})}};
    }
    void write(const std::string& name, const std::string& text) const { cleave::write_file_atomic(folder_ / name, text); }
    cleave::ScratchFolder folder_;
};

TEST_F(FieldFiles, AreReadAsTheyWereWritten) {
    write("a/stress_field.json", field().dump());
    const json read = read_fields(folder_, results({"a/stress_field.json", "a/profile.csv", "a/stress_field.json"}), "results.json");
    ASSERT_EQ(read.size(), 1U) << "tables are read elsewhere";
    EXPECT_EQ(read["a/stress_field.json"], field());
}

TEST_F(FieldFiles, WhatCannotBeDrawnSaysWhy) {
    EXPECT_EQ(read_fields(folder_, results({"a/stress_field.json"}), "results.json")["a/stress_field.json"]["note"], "the file is not in the results folder");
    const auto note = [&](const std::string& text) {
        write("a/stress_field.json", text);
        return read_fields(folder_, results({"a/stress_field.json"}), "results.json")["a/stress_field.json"].value("note", "");
    };
    const std::string wrong = "not a stress field of schema cleave.stress_field/1";
    EXPECT_EQ(note(field().dump()), "");
    EXPECT_EQ(note("{"), wrong);
    EXPECT_EQ(note("[]"), wrong);
    for (const char* key : {"schema", "shown", "measures", "position", "radius", "stress", "difference"}) {
        json cut = field();
        cut.erase(key);
        EXPECT_EQ(note(cut.dump()), wrong) << key;
    }
    json more = field();
    more["shown"] = 2;
    EXPECT_EQ(note(more.dump()), wrong) << "fewer numbers than points";
}

TEST_F(FieldFiles, NeverReadsOutsideTheFolder) {
    for (const char* file : {"../stress_field.json", "/stress_field.json"}) EXPECT_THROW(read_fields(folder_, results({file}), "results.json"), cleave::InputError) << file;
}

TEST_F(FieldFiles, ThePageStaysSmall) {
    json large = field();
    large["about"] = std::string(9'000'000, 'x');
    write("a/stress_field.json", large.dump());
    write("b/stress_field.json", large.dump());
    write("c/stress_field.json", field().dump());
    const json read = read_fields(folder_, results({"a/stress_field.json", "b/stress_field.json", "c/stress_field.json"}), "results.json");
    EXPECT_FALSE(read["a/stress_field.json"].contains("note"));
    EXPECT_EQ(read["b/stress_field.json"]["note"], "9.0 MB, too much for this page");
    EXPECT_FALSE(read["c/stress_field.json"].contains("note")) << "the smallest goes first";
}

}  // namespace
