#include "validation/headline.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::validation {
namespace {

Row stress_row(const std::string& solver, std::optional<Side> against, const std::string& source, double error, Verdict verdict) {
    Row row;
    row.quantity = "stress";
    row.solver = solver;
    row.side = solver.starts_with("fem") ? Side::fem : Side::particles;
    row.reference_side = against;
    row.reference_source = source;
    row.measurement.relative_error = error;
    row.verdict = verdict;
    if (verdict != Verdict::info) row.band.relative = 1;
    return row;
}

CaseResult of_rows(const std::string& name, std::vector<Row> rows) { return {name, "verification", "", "cleave validate " + name, {}, std::move(rows)}; }

Headline headline_of(std::vector<Row> rows) { return headline({of_rows("a", std::move(rows))}); }

TEST(Headline, JudgedAndRecordedAreApart) {
    const Headline found = headline_of({stress_row("sph.corrected", Side::fem, "fem.p2", 0.01, Verdict::pass), stress_row("sph.paper", Side::fem, "fem.p2", 0.3, Verdict::info)});
    ASSERT_TRUE(found.particle_stress && found.recorded_particle_stress);
    EXPECT_EQ(found.particle_stress->error, 0.01);
    EXPECT_EQ(found.particle_stress->row, 0U);
    EXPECT_EQ(found.recorded_particle_stress->error, 0.3);
    EXPECT_EQ(found.recorded_particle_stress->row, 1U);
    EXPECT_EQ(found.recorded_particle_stress->case_name, "a");
    EXPECT_EQ(found.recorded_particle_stress->against, "fem.p2");
    EXPECT_EQ(found.recorded_particle_stress->why, "the case sets no band for sph.paper");
}

TEST(Headline, ADifferenceBesideAJudgedOneSaysWhatIsJudgedInstead) {
    Row row = stress_row("sph.conforming", Side::mathematics, "Lame", 0.02, Verdict::pass);
    row.also.push_back({Side::fem, "fem.p2", 1.0, 0.2, true});
    const Headline found = headline_of({row});
    EXPECT_FALSE(found.particle_stress);
    ASSERT_TRUE(found.recorded_particle_stress);
    EXPECT_EQ(found.recorded_particle_stress->error, 0.2);
    EXPECT_EQ(found.recorded_particle_stress->why, "sph.conforming is judged against Lame");
}

TEST(Headline, TheCasesOwnReasonGoesFirst) {
    Row row = stress_row("sph.paper", Side::fem, "fem.p2", 0.3, Verdict::info);
    row.basis = "a counter-example";
    EXPECT_EQ(headline_of({row}).recorded_particle_stress->why, "a counter-example");
}

TEST(Headline, TheLargestOfAllCasesIsTaken) {
    const auto row = [](double error) { return stress_row("sph.paper", Side::fem, "fem.p2", error, Verdict::info); };
    const Headline found = headline({of_rows("a", {row(0.1)}), of_rows("b", {row(0.2), row(0.4)}), of_rows("c", {row(0.3)})});
    EXPECT_EQ(found.recorded_particle_stress->case_name, "b");
    EXPECT_EQ(found.recorded_particle_stress->row, 1U);
}

// What must not pass for a recorded difference: a must-fail twin, a judged row's own error, another quantity, an absolute error, the
// finite elements' own error, a number that is none.
TEST(Headline, NothingElseIsRecorded) {
    Row twin = stress_row("sph.paper", Side::fem, "fem.p2", 0.9, Verdict::info), strain = twin, absolute = twin;
    twin.must_fail = true;
    twin.also.push_back({Side::fem, "fem.p2", 1.0, 0.9, true});
    strain.quantity = "strain";
    absolute.relative = false;
    Row beside = stress_row("sph.paper", Side::mathematics, "Lame", 0.9, Verdict::info);
    beside.also = {{Side::mathematics, "Lame", 1.0, 0.9, true}, {Side::fem, "fem.p2", 1.0, 0.9, false}};
    const Row elements = stress_row("fem.p2", Side::fem, "fem.p1", 0.9, Verdict::info), judged = stress_row("sph.corrected", Side::fem, "fem.p2", 0.9, Verdict::pass);
    const Row none = stress_row("sph.paper", Side::fem, "fem.p2", std::nan(""), Verdict::info);
    EXPECT_FALSE(headline_of({twin, strain, absolute, beside, elements, judged, none}).recorded_particle_stress);
}

}  // namespace
}  // namespace cleave::validation
