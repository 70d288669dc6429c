#include "benchmarks/compare.hpp"

#include "benchmarks/instructions.hpp"
#include "benchmarks/timing.hpp"
#include "solver/input/input_error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <random>

namespace cleave::benchmarks {
namespace {

using nlohmann::json;

json run_of(const json& counters, const std::string& name = "subdivision/engine/cube_945k") {
    json row = counters;
    row["name"] = name;
    row["run_type"] = "iteration";
    row["real_time"] = 1.0;
    return {{"benchmarks", json::array({row})}};
}

std::string verdict_of(const json& before, const json& after) {
    const Comparison found = compare(run_of(before), run_of(after));
    return found.changes.size() == 1 ? found.changes[0].verdict : "none";
}

TEST(Compare, RatiosSpeedupsAndInstructionsHaveTheirDirections) {
    EXPECT_EQ(verdict_of({{"ratio_to_stores", 1.5}}, {{"ratio_to_stores", 1.9}}), "worse");
    EXPECT_EQ(verdict_of({{"ratio_to_stores", 1.5}}, {{"ratio_to_stores", 1.2}}), "better");
    EXPECT_EQ(verdict_of({{"ratio_to_stores", 1.5}}, {{"ratio_to_stores", 1.6}}), "same");
    EXPECT_EQ(verdict_of({{"speedup_over_vtk", 20}}, {{"speedup_over_vtk", 15}}), "worse");
    EXPECT_EQ(verdict_of({{"speedup_over_vtk", 20}}, {{"speedup_over_vtk", 25}}), "better");
    EXPECT_EQ(verdict_of({{"instructions_per_child", 100}}, {{"instructions_per_child", 102}}), "worse");
    EXPECT_EQ(verdict_of({{"instructions_per_child", 100}}, {{"instructions_per_child", 100.5}}), "same");
    EXPECT_EQ(verdict_of({{"ratio_to_stores", 1.5}}, {{"ratio_to_stores", std::numeric_limits<double>::quiet_NaN()}}), "worse");
}

TEST(Compare, TimesAreNotJudged) {
    const Comparison found = compare(run_of({{"milliseconds", 1.0}, {"ratio_to_stores", 1.5}}), run_of({{"milliseconds", 50.0}, {"ratio_to_stores", 1.5}}));
    ASSERT_EQ(found.changes.size(), 1u);
    EXPECT_EQ(exit_code(found), 0);
}

TEST(Compare, RefusesOtherWork) {
    const Comparison found = compare(run_of({{"n31", 100}, {"ratio_to_stores", 1.5}}), run_of({{"n31", 101}, {"ratio_to_stores", 1.5}}));
    EXPECT_TRUE(found.changes.empty());  // not judged at all
    ASSERT_EQ(found.mismatches.size(), 1u);
    EXPECT_EQ(exit_code(found), 2);
    EXPECT_NE(table(found).find("refused"), std::string::npos);
}

TEST(Compare, MissingRowsAreToldAndNothingInCommonIsRefused) {
    const Comparison found = compare(run_of({{"ratio_to_stores", 1.5}}, "a"), run_of({{"ratio_to_stores", 1.5}}, "b"));
    EXPECT_EQ(found.missing, std::vector<std::string>{"a"});
    EXPECT_EQ(exit_code(found), 2);
}

TEST(Compare, TheTableShowsOldNewRatioNoiseAndVerdict) {
    const std::string text = table(compare(run_of({{"ratio_to_stores", 1.5}, {"noise_to_stores", 0.05}}),
                                           run_of({{"ratio_to_stores", 3.0}, {"noise_to_stores", 0.05}})));
    for (const char* word : {"ratio_to_stores", "1.5", "3", "2.000", "21.2%", "worse"}) EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
}

/// A machine that charges each contestant its work, times noise that is the same for both within a pair (drift) or not (jitter): what
/// paired_times would measure, without a clock.
class ImaginaryMachine {
public:
    explicit ImaginaryMachine(std::uint64_t seed) : engine_(seed) {}
    json row(double slowdown) {
        std::vector<double> ratios;
        for (int pass = 0; pass < 21; ++pass) {
            const double drift = 1 + noise(1.0);  // the machine is up to twice as slow for a while
            ratios.push_back(drift * 1.5 * slowdown * (1 + noise(0.15)) / (drift * (1 + noise(0.15))));
        }
        return {{"n31", 100}, {"ratio_to_stores", median(ratios)}, {"noise_to_stores", relative_noise(ratios)}};
    }

private:
    double noise(double size) { return size * static_cast<double>(engine_() >> 11) * 0x1p-53; }
    std::mt19937_64 engine_;
};

TEST(Compare, CatchesASlowedBuildAndLeavesNoiseAlone) {
    int caught = 0, false_alarms = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        ImaginaryMachine before(2 * seed), after(2 * seed + 1);
        const json baseline = run_of(before.row(1));
        false_alarms += exit_code(compare(baseline, run_of(after.row(1)))) != 0;
        caught += exit_code(compare(baseline, run_of(after.row(1.3)))) == 1;  // a third slower
    }
    EXPECT_EQ(false_alarms, 0);
    EXPECT_EQ(caught, 300);
}

TEST(Instructions, AreReadFromCallgrindsOutput) {
    EXPECT_EQ(counted_instructions("version: 1\nevents: Ir\nfn=(1) f\n10 20\ntotals: 8130412\n"), 8130412);
    EXPECT_THROW(counted_instructions("version: 1\n"), EnvironmentError);
}

TEST(RelativeNoise, ShrinksWithTheRootOfThePasses) {
    std::vector<double> few{0.9, 1, 1.1}, many;
    for (int i = 0; i < 400; ++i) many.push_back(0.9 + 0.2 * (i % 3) / 2);
    EXPECT_GT(relative_noise(few), 0);
    EXPECT_NEAR(relative_noise(many), 0.1 / 20, 1e-12);
}

}  // namespace
}  // namespace cleave::benchmarks
