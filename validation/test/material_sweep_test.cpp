#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "validation/case_store.hpp"
#include "validation/runner.hpp"
#include "validation/studies/stiffness_csv.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cleave::validation {
namespace {

const std::string cubic_and_isotropic = R"(silicon,165.7,63.9,63.9,0,0,0,165.7,63.9,0,0,0,165.7,0,0,0,79.6,0,0,79.6,0,79.6
germanium,128.5,48.3,48.3,0,0,0,128.5,48.3,0,0,0,128.5,0,0,0,66.8,0,0,66.8,0,66.8
glass,80,20,20,0,0,0,80,20,0,0,0,80,0,0,0,30,0,0,30,0,30
)";

const std::string sweep = R"(name = "sweep"
tier = "verification"
about = "a sweep for the tests"
[study]
name = "material_sweep"
csv = "tensors.csv"
seed = 1
quick_random = 8
full_random = 8
quick_pennies = 1
full_pennies = 1
size = "0.4 m"
penny_size = 0.2
[[check]]
quantity = "QUANTITY"
solver = ["METHOD"]
reference = { value = 0, source = "mathematics" }
band = { absolute = 1e-8 }
basis = "rounding"
)";

std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// The table lies beside the case, as the case says.
Case written(const ScratchFolder& folder, const std::string& text, const std::string& table = cubic_and_isotropic) {
    write_file_atomic(folder / "sweep.toml", text);
    write_file_atomic(folder / "tensors.csv", table);
    return read_cases((folder / "sweep.toml").string(), {}).at(0);
}

std::vector<Row> rows_of(const ScratchFolder& folder, const std::string& quantity, const std::string& method,
                         const std::string& table = cubic_and_isotropic) {
    const Case of = written(folder, with(with(sweep, "QUANTITY", quantity), "METHOD", method), table);
    return run_case(of, {"quick", folder / "out", {}}).result.rows;
}

TEST(MaterialSweep, RowsAreOfTheClassesInTheTableAndNameTheWorst) {
    const ScratchFolder folder;
    const std::vector<Row> rows = rows_of(folder, "bar_modulus_error", "fem.p2");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].place, "cubic");
    EXPECT_TRUE(rows[0].detail.starts_with("worst of 2: ")) << rows[0].detail;
    EXPECT_EQ(rows[1].detail, "worst of 1: glass");
    EXPECT_EQ(rows[1].place, "isotropic");
    for (const Row& row : rows) EXPECT_EQ(row.verdict, Verdict::pass) << row.place;
}

// A bar that is confined is stiffer than a free one: the mistake shows for every tensor, and must miss the band for each of them.
TEST(MaterialSweep, OfAMistakeTheTensorThatShowsItLeastCounts) {
    const ScratchFolder folder;
    const std::vector<Row> rows = rows_of(folder, "bar_modulus_error", "stiffness_along");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_TRUE(rows[0].detail.starts_with("least of 2: ")) << rows[0].detail;
    EXPECT_NEAR(*rows[1].measurement.value, 80.0 / 72 - 1, 1e-9) << "C11 / E of glass: E = (C11 - C12)(C11 + 2 C12)/(C11 + C12) = 72";
    for (const Row& row : rows) EXPECT_EQ(row.verdict, Verdict::fail) << row.place;
}

// Stable, but of condition 1e11: the particles' iteration finds no equilibrium. Its row fails by its name, the others are what they were.
TEST(MaterialSweep, ATensorThatNoSolveTakesFailsByNameAndTheOthersGoOn) {
    const ScratchFolder folder;
    const std::string with_soft = cubic_and_isotropic + "soft,165.7,63.9,63.9,0,0,0,165.7,63.9,0,0,0,165.7,0,0,0,1e-9,0,0,79.6,0,79.6\n";
    const std::vector<Row> rows = rows_of(folder, "bar_modulus_error", "sph.conforming", with_soft);
    ASSERT_EQ(rows.size(), 3U);
    for (const Row& row : rows) EXPECT_EQ(row.verdict, row.detail == "worst of 1: soft" ? Verdict::fail : Verdict::pass) << row.detail;
    EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.detail == "worst of 1: soft"; }));
}

TEST(MaterialSweep, EveryErrorIsWrittenAndTheTableCanBeReadBack) {
    const ScratchFolder folder;
    (void)rows_of(folder, "wave_speed_error", "solver");
    const std::string errors = read_file(folder / "out/sweep/sweep.csv");
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 4);
    EXPECT_EQ(errors.substr(0, errors.find(',')), "tensor");
    EXPECT_NE(errors.find("patch_error of fem.p2"), std::string::npos);
    EXPECT_EQ(errors.find("kelvin_as_voigt"), std::string::npos);
    const auto again = read_stiffness_csv(folder / "out/sweep/tensors.csv"), given = read_stiffness_csv(folder / "tensors.csv");
    ASSERT_EQ(again.size(), given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
        EXPECT_EQ(again[i].name, given[i].name);
        EXPECT_LT((again[i].stiffness - given[i].stiffness).norm(), 1e-3) << "Pa: one rounding of GPa and back";
    }
}

TEST(MaterialSweep, AnotherTableIsAnotherCase) {
    const ScratchFolder folder;
    const std::string text = with(with(sweep, "QUANTITY", "patch_error"), "METHOD", "fem.p2");
    const CaseStore store(folder / "out", "quick");
    const Case first = written(folder, text);
    FinishedCase finished;
    finished.result.name = first.name;
    store.save(first, finished);
    EXPECT_TRUE(store.find(written(folder, text)));
    EXPECT_FALSE(store.find(written(folder, text, with(cubic_and_isotropic, "79.6", "79.7"))));
}

TEST(MaterialSweep, MistakesInTheTableAndTheKeysAreNamed) {
    const ScratchFolder folder;
    const std::string text = with(with(sweep, "QUANTITY", "patch_error"), "METHOD", "fem.p2");
    const auto error_of = [&](const std::string& of, const std::string& table = cubic_and_isotropic) -> std::string {
        try {
            (void)written(folder, of, table);
        } catch (const InputError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_NE(error_of(text, with(cubic_and_isotropic, "germanium,128.5,", "germanium,")).find("tensors.csv:2: expected 21 numbers"), std::string::npos);
    EXPECT_NE(error_of(with(text, "\"tensors.csv\"", "\"none.csv\"")).find("sweep.toml:6: study.csv: expected an existing file"), std::string::npos);
    EXPECT_NE(error_of(with(text, "\"0.4 m\"", "\"4 m\"")).find("study.size: expected a length from 2 cm to 1 m"), std::string::npos);
    EXPECT_NE(error_of(with(text, "quick_random = 8", "quick_random = 7")).find("study.quick_random: expected an integer from 8"), std::string::npos);
    EXPECT_NE(error_of(with(text, "penny_size = 0.2", "penny_size = 0.2\nfull_penny_size = 0")).find("study.full_penny_size: expected a number from"), std::string::npos);
    EXPECT_NE(error_of(with(text, "penny_size = 0.2", "penny_size = 2")).find("study.penny_size: expected a number from"), std::string::npos);
}

}  // namespace
}  // namespace cleave::validation
