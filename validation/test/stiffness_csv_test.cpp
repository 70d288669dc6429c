#include "validation/studies/stiffness_csv.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace cleave::validation {
namespace {

const std::string steel = "269.2,115.4,115.4,0,0,0,269.2,115.4,0,0,0,269.2,0,0,0,76.9,0,0,76.9,0,76.9";
const std::string titles = "name,C11,C12,C13,C14,C15,C16,C22,C23,C24,C25,C26,C33,C34,C35,C36,C44,C45,C46,C55,C56,C66\n";

std::vector<NamedStiffness> read(const std::string& text) {
    const ScratchFolder folder;
    write_file_atomic(folder / "tensors.csv", text);
    return read_stiffness_csv(folder / "tensors.csv");
}

std::string with(std::string text, char from, char to) {
    for (char& c : text)
        if (c == from) c = to;
    return text;
}

TEST(StiffnessCsv, ConstantsStandWhereTheTriangleHasThem) {
    std::string row = "90";  // C11; every further constant its own, small beside the diagonal
    for (int i = 1, at = 1; i < 7; ++i)
        for (int j = i; j < 7; ++j)
            if (i + j > 2) row += "," + std::to_string(i == j ? 90 + ++at : ++at) ;
    const material::Stiffness c = read("skew," + row).at(0).stiffness / 1e9;
    double next = 1;
    for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) {
            if (i + j == 0) continue;
            ++next;
            EXPECT_NEAR(c(i, j), i == j ? 90 + next : next, 1e-9) << i << j;
            EXPECT_EQ(c(i, j), c(j, i));
        }
    EXPECT_NEAR(c(0, 0), 90, 1e-9);
}

TEST(StiffnessCsv, TitlesNamesAndSeparatorsAreFree) {
    const std::vector<std::string> texts{titles + "steel," + steel, "\xef\xbb\xbf" + titles + "steel," + steel + "\r\n", "# of a handbook\n\n\"steel\", " + steel,
                                         with("steel," + steel, ',', ';'), with("steel," + steel, ',', '\t')};
    for (const std::string& text : texts) {
        const auto tensors = read(text);
        ASSERT_EQ(tensors.size(), 1U) << text;
        EXPECT_EQ(tensors[0].name, "steel") << text;
        EXPECT_NEAR(tensors[0].stiffness(0, 1), 115.4e9, 1) << text;
    }
    EXPECT_EQ(read(steel + "\n\"steel, hot\"," + steel).at(0).name, "line 1");
    EXPECT_EQ(read(steel + "\n\"steel, hot\"," + steel).at(1).name, "steel, hot");
    EXPECT_EQ(read(titles + "," + steel).at(0).name, "line 2") << "an empty name is none";
}

std::string error_of(const std::string& text) {
    try {
        (void)read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(StiffnessCsv, BadLinesAreNamed) {
    struct Row { std::string text, expected; };
    const std::string negative = "100,0,0,0,0,0,100,0,0,0,0,100,0,0,0,-1,0,0,20,0,20";
    const std::vector<Row> rows{
        {titles + "steel," + steel + "\nshort," + steel.substr(0, steel.size() - 5), "tensors.csv:3: expected 21 numbers in GPa, C11, C12, ..., C16, C22, ..., C66"},
        {"long,1,2," + steel, "tensors.csv:1: expected 21 numbers"},
        {"nan," + with(steel, '9', 'x'), "tensors.csv:1: expected a finite number in GPa (not '26x.2')"},
        {"steel,nan" + steel.substr(5), "tensors.csv:1: expected a finite number in GPa (not 'nan')"},
        {"steel,inf" + steel.substr(5), "tensors.csv:1: expected a finite number in GPa (not 'inf')"},
        {"steel," + steel.substr(5), "tensors.csv:1: expected a finite number in GPa (not '')"},
        {"steel," + steel + "\nsoft," + negative, "tensors.csv:2: expected a positive definite stiffness"},
        {"steel," + steel + "\nsteel," + steel, "tensors.csv:2: expected a name of its own (not 'steel' again)"},
        {titles + titles, "tensors.csv:2: expected a finite number"},
        {"word\nword", "tensors.csv:2: expected 21 numbers"},
        {titles, "tensors.csv: expected lines of 21 constants"},
        {"", "tensors.csv: expected lines of 21 constants"}};
    for (const Row& row : rows) {
        const std::string error = error_of(row.text);
        EXPECT_NE(error.find(row.expected), std::string::npos) << "expected: " << row.expected << "\n  got: " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
    EXPECT_NE(error_of("steel," + steel + "\nsoft," + negative).find("'soft'"), std::string::npos);
    EXPECT_THROW(read_stiffness_csv("no such file.csv"), InputError);
}

}  // namespace
}  // namespace cleave::validation
