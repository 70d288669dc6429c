#include "solver/input/read_values.hpp"

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

TEST(ReadValues, IntegersAreNotCutToTheirLowBits) {
    TableReader reader = TableReader::from_text("low = 1\nhigh = 1000\n", "t");
    EXPECT_EQ(read_integer(reader, "low", 1, 1000), 1);
    EXPECT_EQ(read_integer(reader, "high", 1, 1000), 1000);
    for (const char* text : {"n = 0\n", "n = 1001\n", "n = 4294967297\n", "n = -4294967295\n"})
        EXPECT_EQ(message_of(text, [](TableReader& bad) { read_integer(bad, "n", 1, 1000); }), "case.toml:1: n: expected an integer from 1 to 1000");
}

TEST(ReadValues, DirectionsCanBeNormalised) {
    TableReader reader = TableReader::from_text("d = [0, -2, 1e-3]\n", "t");
    EXPECT_EQ(read_direction(reader, "d"), (std::array<double, 3>{0, -2, 1e-3}));
    for (const char* text : {"d = [0, 0, 0]\n", "d = [1, 2]\n"})
        EXPECT_EQ(message_of(text, [](TableReader& bad) { read_direction(bad, "d"); }), "case.toml:1: d: expected three numbers, not all zero");
    for (const char* text : {"d = [1e200, 1e200, 0]\n", "d = [1e-161, 0, 0]\n"})
        EXPECT_EQ(message_of(text, [](TableReader& bad) { read_direction(bad, "d"); }), "case.toml:1: d: expected a direction of length 1e-100 to 1e+100");
}

TEST(ReadValues, ListsOfQuantitiesCarryTheirUnits) {
    TableReader reader = TableReader::from_text("many = [\"1 m\", \"2 mm\"]\none = \"3 cm\"\n", "t");
    EXPECT_EQ(read_quantities(reader, "many", dimension::length), (std::vector<double>{1, 0.002}));
    EXPECT_EQ(read_quantities(reader, "one", dimension::length), std::vector<double>{0.03});
    EXPECT_EQ(message_of("many = [\"1 m\", \"thin\"]\n", [](TableReader& bad) { read_quantities(bad, "many", dimension::length); }),
              "case.toml:1: many: expected a finite number with a unit (not 'thin')");
    EXPECT_EQ(message_of("many = [\"1 m\", \"1 s\"]\n", [](TableReader& bad) { read_quantities(bad, "many", dimension::length); }),
              "case.toml:1: many: expected quantities in m (not '1 s')");
}

}  // namespace
}  // namespace cleave
