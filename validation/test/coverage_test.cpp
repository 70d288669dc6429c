#include "validation/coverage.hpp"

#include "validation/case.hpp"
#include "validation/case_checks.hpp"
#include "validation/suite.hpp"
#include "validation/symmetry_class.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace cleave::validation {
namespace {

/// What a case's checks would give rows for, without running it.
CaseResult planned(const Case& of) {
    CaseResult result;
    result.name = of.name;
    result.symmetry = of.symmetry();
    for (const Check& check : of.checks)
        for (const std::string& solver : check.solvers) {
            Row row;
            row.quantity = check.observable.quantity;
            row.side = of.side(solver);
            row.reference_side = reference_side(check, of);
            row.must_fail = check.must_fail;
            result.rows.push_back(row);
        }
    return result;
}

std::vector<CaseResult> shipped() {
    std::vector<CaseResult> all;
    for (const auto& file : shipped_case_files())
        for (const Case& one : read_cases(file.string(), {})) all.push_back(planned(one));
    return all;
}

TEST(Coverage, EveryEmptyCellOfTheShippedCasesIsExplained) {
    for (const CoverageCell& cell : coverage(shipped()))
        EXPECT_TRUE(cell.checks > 0 || !cell.why.empty()) << fmt::format("{}, {}, {}", cell.symmetry, cell.family, name(cell.method));
}

// What the reasons for empty cells lean on: the general tensor, and the class that most literature is about.
TEST(Coverage, StressOfGeneralAndIsotropicBodiesIsCoveredByAllThree) {
    for (const CoverageCell& cell : coverage(shipped()))
        if (cell.family == "stress" && (cell.symmetry == "triclinic" || cell.symmetry == "isotropic")) {
            EXPECT_GT(cell.checks, 0) << cell.symmetry << ", " << name(cell.method);
        }
}

// The must-fail twins: without the cases there is nothing, and a check that must fail covers nothing.
TEST(Coverage, NothingCoversNothing) {
    for (const CoverageCell& cell : coverage({})) EXPECT_EQ(cell.checks, 0);
    auto cases = shipped();
    for (CaseResult& of : cases)
        for (Row& row : of.rows) row.must_fail = true;
    for (const CoverageCell& cell : coverage(cases)) EXPECT_EQ(cell.checks, 0);
}

// A sweep's row is of one class, whatever else its case has.
TEST(Coverage, ARowWithAClassForItsPlaceCountsForThatClassOnly) {
    CaseResult sweep;
    sweep.name = "sweep";
    sweep.symmetry = {"cubic", "triclinic"};
    Row row;
    row.quantity = "patch_error";
    row.side = Side::fem;
    row.place = "cubic";
    sweep.rows = {row};
    for (const CoverageCell& cell : coverage({sweep}))
        EXPECT_EQ(cell.checks, cell.symmetry == "cubic" && cell.family == "stress" && cell.method == Side::fem ? 1 : 0)
            << fmt::format("{}, {}, {}", cell.symmetry, cell.family, name(cell.method));
}

TEST(Coverage, QuantitiesOfBodiesBelongToAFamily) {
    const std::vector<std::string> of_the_method{"vertex_sensitivity", "force_error_as_printed"};
    for (const QuantityInfo& quantity : quantities())
        EXPECT_TRUE(!quantity_family(quantity.name).empty() || std::find(of_the_method.begin(), of_the_method.end(), quantity.name) != of_the_method.end()) << quantity.name;
}

}  // namespace
}  // namespace cleave::validation
