#include "solver/input/toml_guard.hpp"

#include "solver/input/input_error.hpp"

#include <gtest/gtest.h>

namespace cleave {
namespace {

std::string answer_to(const std::string& text) try {
    require_safe_toml(text, "a.toml");
    return "fine";
} catch (const InputError& error) {
    return error.what();
}

TEST(TomlGuard, LettersBeyondAsciiStandInStringsAndComments) {
    EXPECT_EQ(answer_to("size = \"5 µm\"  # Größe\nname = 'ʍ'\n"), "fine");
    EXPECT_EQ(answer_to("about = \"\"\"one µ\n two \\\"\"\" µ\"\"\"\nmore = '''µ'''\n"), "fine");
    EXPECT_EQ(answer_to("quoted = \"\"\"a \"b\"\"\"\"\" # the first two of five are its own: µ\n"), "fine");
    EXPECT_EQ(answer_to("\xEF\xBB\xBFname = \"after a byte order mark\"\n"), "fine");
    for (const char* bad : {"name = \"x\"\n[ʍa'", "name = \"x\"\nµ = 1", "a = 1\nb =\u00a02"})
        EXPECT_EQ(answer_to(bad), "a.toml:2: expected valid TOML (letters beyond ASCII in strings and comments only)") << bad;
}

TEST(TomlGuard, KeysHaveAHundredParts) {
    std::string key = "k";
    for (int i = 1; i < 100; ++i) key += ".k";
    EXPECT_EQ(answer_to(key + " = 1\n" + key + " = 2\n"), "fine") << "each for itself";
    EXPECT_EQ(answer_to("x = 1\n" + key + ".k = 1\n"), "a.toml:2: expected keys of at most 100 parts");
}

}  // namespace
}  // namespace cleave
