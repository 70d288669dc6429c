#include "solver/input/table_reader.hpp"

#include "solver/input/input_error.hpp"

#include <gtest/gtest.h>

namespace cleave {
namespace {

std::string message_of(const std::string& text, void (*use)(TableReader&)) {
    try {
        TableReader reader = TableReader::from_text(text, "case.toml");
        use(reader);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(TableReader, ReadsQuantitiesInSi) {
    TableReader reader = TableReader::from_text("[a]\nlength = \"3 mm\"\nload = [\"0 Pa\", \"0 Pa\", \"1 MPa\"]\nangle = \"90 deg\"\n", "t");
    TableReader table = reader.table("a");
    EXPECT_DOUBLE_EQ(table.quantity("length", dimension::length), 0.003);
    EXPECT_EQ(table.vector("load", dimension::pressure), (std::array<double, 3>{0, 0, 1e6}));
    EXPECT_DOUBLE_EQ(table.angle("angle"), 1.5707963267948966);
    EXPECT_NO_THROW(reader.finish());
}

TEST(TableReader, AMisspeltKeyIsRejectedWithFileLineAndHint) {
    EXPECT_EQ(message_of("[geometry]\nshape = \"block\"\nhalf_widht = \"1 m\"\n",
                         [](TableReader& reader) {
                             TableReader geometry = reader.table("geometry");
                             geometry.string("shape");
                             geometry.quantity_or("half_width", dimension::length, 1);
                             reader.finish();
                         }),
              "case.toml:3: geometry.half_widht: expected a known key; did you mean 'half_width'?");
}

TEST(TableReader, AMissingKeyPointsToItsMisspelling) {
    EXPECT_EQ(message_of("other = 1\nshpae = \"block\"\n", [](TableReader& reader) { reader.string("shape"); }),
              "case.toml:1: shape: expected a string (the key is missing; 'shpae' in line 2 looks like it)");
}

TEST(TableReader, AWrongUnitNamesTheExpectedOne) {
    EXPECT_EQ(message_of("width = \"1 kg\"\n", [](TableReader& reader) { reader.quantity("width", dimension::length); }),
              "case.toml:1: width: expected a quantity with a unit like '1 m' (not kg)");
    EXPECT_EQ(message_of("width = 1.5\n", [](TableReader& reader) { reader.quantity("width", dimension::length); }),
              "case.toml:1: width: expected a quantity with a unit like '1 m' (not 1)");
}

TEST(TableReader, MissingKeysAndWrongTypesAreInputErrors) {
    EXPECT_NE(message_of("a = 1\n", [](TableReader& reader) { reader.string("name"); }).find("name: expected a string (the key is missing)"),
              std::string::npos);
    EXPECT_NE(message_of("a = nan\n", [](TableReader& reader) { reader.number("a"); }).find("a finite number"), std::string::npos);
    EXPECT_NE(message_of("a = \"x\"\n", [](TableReader& reader) { reader.choice("a", {"b", "c"}); }).find("one of b, c (not 'x')"),
              std::string::npos);
    EXPECT_NE(message_of("a = [1, 2\n", [](TableReader&) {}).find("case.toml:"), std::string::npos);
}

TEST(TableReader, KeysOfManyPartsDoNotExhaustTheStack) {
    std::string key = "a";
    for (int part = 1; part < 1'000'000; ++part) key += part % 2 == 0 ? ".a" : " . \"a, #b\"";
    for (const std::string& text : {key + " = 1\n", "[" + key + "]\n", "x = { " + key + " = 1 }\n"})
        EXPECT_NE(message_of(text, [](TableReader&) {}).find("case.toml:1: expected keys of at most 100 parts"), std::string::npos);
    EXPECT_EQ(message_of("about = \"" + std::string(500, '.') + "\"\n# " + std::string(500, '.') + "\n", [](TableReader&) {}), "no error");
    std::string numbers = "0.5";
    for (int i = 0; i < 500; ++i) numbers += ", 0.5";
    EXPECT_EQ(message_of("n = [" + numbers + "]\n", [](TableReader&) {}), "no error");
}

TEST(TableReader, OverridesReplaceValuesByDottedKey) {
    TableReader reader = TableReader::from_text("[load]\npressure = \"1 MPa\"\nsteps = 2\n", "t");
    reader.set("load.pressure", "2 MPa");
    reader.set("load.steps", "5");
    TableReader load = reader.table("load");
    EXPECT_DOUBLE_EQ(load.quantity("pressure", dimension::pressure), 2e6);
    EXPECT_EQ(load.integer("steps"), 5);
    EXPECT_THROW(reader.set("laod.steps", "5"), InputError);
}

}  // namespace
}  // namespace cleave
