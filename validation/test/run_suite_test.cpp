#include "validation/run_suite.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "validation/merge.hpp"
#include "validation/processes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

namespace cleave::validation {
namespace {

namespace fs = std::filesystem;

/// One number; says in a file of the folder that it was run.
class Counted final : public Study {
public:
    explicit Counted(double value) : value_(value) {}
    StudyOutcome run(const StudyContext& context) const override {
        if (value_ < 0) throw InputError("negative.toml", "value", "a positive number");
        const fs::path log = context.out / (context.folder + ".runs");
        write_file_atomic(log, (fs::exists(log) ? read_file(log) : "") + "x");
        StudyOutcome outcome;
        outcome.values.push_back({"length", "rule", "", value_});
        return outcome;
    }

private:
    double value_;
};

Case counted(const std::string& name, double value) {
    Check check;
    check.observable.quantity = "length";
    check.unit = dimension::length;
    check.solvers = {"rule"};
    check.where = "check[0]";
    check.reference = {Reference::Kind::value, 1.0 / 3, "a third", std::nullopt};
    check.bands[""].relative = 1e-6;
    check.basis = "a test";
    Case one;
    one.name = name;
    one.file = name + ".toml";
    one.tier = "verification";
    one.study = std::make_shared<Counted>(value);
    one.checks = {check};
    one.ladder = {{"quick", {0}}};
    one.text = name;
    return one;
}

std::vector<Case> five() {
    std::vector<Case> cases;
    for (int i = 0; i < 5; ++i) cases.push_back(counted("case_" + std::to_string(i), 1.0 / (3 + i)));
    return cases;
}

class RunSuite : public testing::Test {
protected:
    std::string json(const std::vector<Case>& cases, int jobs, bool reuse) const {
        std::vector<CaseResult> results;
        std::vector<std::size_t> order;
        run_suite(cases, {"quick", out_, jobs, reuse}, [&](std::size_t i, FinishedCase& one) {
            order.push_back(i);
            results.push_back(one.result);
        });
        EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
        return results_json(results, "quick");
    }
    std::string runs(const std::string& name) const {
        const fs::path log = out_ / (name + ".runs");
        return fs::exists(log) ? read_file(log) : "";
    }
    ScratchFolder scratch_;
    fs::path out_ = scratch_.path();
};

TEST_F(RunSuite, AnyNumberOfProcessesGivesTheSameBytes) {
    const std::string alone = json(five(), 1, false);
    EXPECT_EQ(json(five(), 3, false), alone);
    EXPECT_EQ(json(five(), 8, false), alone);
    EXPECT_NE(alone.find("\"pass\": 1"), std::string::npos) << alone;
    EXPECT_EQ(runs("case_4"), "xxx") << "each run anew";
}

TEST_F(RunSuite, FinishedCasesAreNotRunAgainUnlessTheirInputChanged) {
    std::vector<Case> cases = five();
    const std::string first = json({cases[0], cases[1]}, 2, true);
    const std::string all = json(cases, 2, true);
    EXPECT_EQ(runs("case_0"), "x");
    EXPECT_EQ(runs("case_4"), "x");
    cases[0].text += " changed";
    EXPECT_EQ(json(cases, 1, true), all);
    EXPECT_EQ(runs("case_0"), "xx");
    EXPECT_EQ(runs("case_1"), "x");
    write_file_atomic(out_ / "cases" / "case_2.json", "{ \"schema\": ");
    EXPECT_EQ(json(cases, 1, true), all);
    EXPECT_EQ(runs("case_2"), "xx") << "a broken file does not count";
}

TEST_F(RunSuite, OneFailureIsTheExitCodeOfAll) {
    std::vector<Case> cases = five();
    cases.insert(cases.begin() + 2, counted("negative", -1));
    try {
        json(cases, 2, false);
        FAIL() << "no failure";
    } catch (const SuiteFailed& failed) {
        EXPECT_EQ(failed.exit_code, 2);
    }
    EXPECT_THROW(json(cases, 1, false), InputError);
}

/// The folder of a run over some of the cases, as the program writes it.
void write_shard(const std::vector<Case>& all, std::size_t index, std::size_t number, const fs::path& out) {
    std::vector<Case> own;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i % number == index) own.push_back(all[i]);
    std::vector<CaseResult> results;
    run_suite(own, {"quick", out, 1, false}, [&](std::size_t, FinishedCase& one) { results.push_back(one.result); });
    write_file_atomic(out / "results.json", results_json(results, "quick"));
}

TEST_F(RunSuite, MergedShardsAreTheUnsplitRunToTheByte) {
    std::vector<Case> cases = five();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        cases[i].position = i;
        cases[i].command = "cleave validate " + cases[i].name;
    }
    const std::string whole = json(cases, 1, false);
    std::vector<fs::path> folders;
    for (std::size_t k = 0; k < 3; ++k) {
        folders.push_back(out_ / ("shard" + std::to_string(k)));
        write_shard(cases, k, 3, folders.back());
    }
    std::reverse(folders.begin(), folders.end());
    const MergedRun merged = merge_runs(folders, out_ / "merged");
    std::vector<CaseResult> results;
    for (const FinishedCase& one : merged.cases) results.push_back(one.result);
    EXPECT_EQ(results_json(results, merged.level), whole);

    folders.push_back(folders.front());
    EXPECT_THROW(merge_runs(folders, out_ / "merged"), InputError) << "a case twice";
    EXPECT_THROW(merge_runs({out_ / "nowhere"}, out_ / "merged"), InputError);
}

TEST(Processes, AnEndBySignalIsABug) {
    EXPECT_EQ(run_in_processes(4, 2, 1, [](std::size_t i) { if (i == 1) ::raise(SIGKILL); }), static_cast<int>(ExitCode::bug));
    EXPECT_EQ(run_in_processes(4, 2, 0, [](std::size_t) {}), 0);
}

}  // namespace
}  // namespace cleave::validation
