#include "benchmarks/json_reporter.hpp"
#include "solver/input/file_io.hpp"
#include "solver/input/test/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

namespace cleave::benchmarks {
namespace {

/// A folder of this process alone, removed with it.
class Program : public testing::Test {
protected:
    struct Outcome {
        int code;
        std::string out, error;
    };
    Outcome run(const std::string& arguments) const {
        const std::string out = (folder_ / "stdout").string(), error = (folder_ / "stderr").string();
        const int status = std::system((std::string(CLEAVE_BENCH_PROGRAM) + " " + arguments + " >'" + out + "' 2>'" + error + "'").c_str());
        return {WEXITSTATUS(status), read_file(out), read_file(error)};
    }

    ScratchFolder folder_;
};

TEST_F(Program, EveryBenchmarkRunsOnceAndCountsItsWork) {
    const std::filesystem::path file = folder_ / "bench.json";
    const Outcome outcome = run("--level quick --filter='-table2/(pet|tai_chi)/' --benchmark_min_time=0 --out '" + file.string() + "'");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const nlohmann::json document = nlohmann::json::parse(read_file(file));
    std::set<std::string> names;
    for (const auto& row : document["benchmarks"]) {
        names.insert(row["name"].get<std::string>());
        EXPECT_FALSE(row.contains("error_occurred"));
        if (!row.contains("n31")) continue;
        EXPECT_EQ(row["particles_after"].get<double>(),
                  row["uncut"].get<double>() + 14 * row["n31"].get<double>() + 20 * row["n22"].get<double>());
        EXPECT_EQ(row["particles_before"].get<double>(), row["uncut"].get<double>() + row["n31"].get<double>() + row["n22"].get<double>());
        EXPECT_GT(row["n31"].get<double>(), 0) << row["name"];
    }
    for (const std::string name : {"table2/pot", "subdivision/plain/pot", "subdivision/stores/pot", "subdivision/engine/cube_6k",
                                   "subdivision/disc/cube_83k", "subdivision/setup/pot", "subdivision/cold/pot",
                                   "subdivision/two_threads/cube_83k", "table2/pots", "table2/glass", "table2/complexity", "fragments/adaptive/cube_945k",
                                   "fragments/basic/cube_83k", "stress_analysis/isotropic", "stress_analysis/anisotropic", "neighbours/cube_83k",
                                   "neighbours/unsorted/cube_6k", "memory/subdivision/cube_83k",
                                   "memory/fragments/cube_83k", "memory/strain/cube_83k", "gradient/cube_83k", "equilibrium/conforming", "equilibrium/fem_p2"}) {
        const bool found = std::any_of(names.begin(), names.end(), [&](const std::string& full) { return full.starts_with(name); });
        EXPECT_TRUE(found) << name;
    }
}

TEST_F(Program, Table2StandsBesideThePapersNumbersAndNamesNoHost) {
    const std::filesystem::path file = folder_ / "bench.json";
    ASSERT_EQ(run("--filter table2/pot/ --benchmark_min_time=0 --out '" + file.string() + "'").code, 0);
    const nlohmann::json document = nlohmann::json::parse(read_file(file));
    const auto& context = document["context"];
    for (const char* key : {"cpu_model", "compiler", "threads", "build_type", "level"}) EXPECT_TRUE(context.contains(key)) << key;
    EXPECT_FALSE(context.contains("host_name"));
    EXPECT_FALSE(context.contains("executable"));
    ASSERT_EQ(document["benchmarks"].size(), 1u);
    const auto& row = document["benchmarks"][0];
    EXPECT_EQ(row["name"], "table2/pot");  // the name the report looks for
    EXPECT_EQ(row["paper_milliseconds"].get<double>(), 2869);
    EXPECT_EQ(row["paper_particles_after"].get<double>(), 15717);
    EXPECT_NEAR(row["paper_milliseconds_per_added"].get<double>(), 0.300, 0.0005);
    const double added = row["particles_after"].get<double>() - row["particles_before"].get<double>();
    EXPECT_NEAR(row["milliseconds_per_added"].get<double>(), row["milliseconds"].get<double>() / added, 1e-9);
}

TEST_F(Program, ComparesTwoRuns) {
    const auto write = [&](const char* name, double n31, double ratio) {
        const nlohmann::json row{{"name", "a"}, {"run_type", "iteration"}, {"n31", n31}, {"ratio_to_stores", ratio}};
        write_file_atomic(folder_ / name, nlohmann::json{{"benchmarks", {row}}}.dump());
        return std::string("'").append((folder_ / name).string()).append("'");
    };
    const std::string old = write("old.json", 10, 1.5), same = write("same.json", 10, 1.52), slow = write("slow.json", 10, 2),
                      other = write("other.json", 11, 1.5), fast = write("fast.json", 10, 1);
    EXPECT_EQ(run("--compare " + old + " --from " + same).code, 0);
    const Outcome worse = run("--compare " + old + " --from " + slow);
    EXPECT_EQ(worse.code, 1);
    EXPECT_NE(worse.out.find("worse"), std::string::npos);
    EXPECT_EQ(run("--compare " + old + " --from " + other).code, 2);
    const Outcome better = run("--compare " + old + " --from " + fast);
    EXPECT_EQ(better.code, 0);
    EXPECT_NE(better.out.find("better"), std::string::npos);
    EXPECT_EQ(run("--compare " + old + " --filter subdivision/stores/pot --benchmark_min_time=0").code, 2);  // no row in common
}

TEST_F(Program, BadArgumentsAreOneLineAndExitCode2) {
    for (const char* arguments : {"--compare /nowhere.json", "--from x.json", "--filter nothing_has_this_name", "--level huge", "--outt x", "--benchmark_nonsense=1", "--filter '['"}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, 2) << arguments << "\n" << outcome.error;
        EXPECT_NE(outcome.error.find("cleave-bench: "), std::string::npos) << arguments;
    }
}

TEST_F(Program, AnUnwritableFileIsExitCode3) {
    EXPECT_EQ(run("--filter subdivision/stores --benchmark_min_time=0 --out /proc/nowhere/bench.json").code, 3);
}

TEST(CpuModel, IsFoundInCpuinfo) {
    std::istringstream text("processor\t: 0\nmodel name\t: Some CPU @ 2 GHz\nmodel name\t: other\n"), none("processor : 0\n");
    EXPECT_EQ(cpu_model(text), "Some CPU @ 2 GHz");
    EXPECT_EQ(cpu_model(none), "unknown");
}

}  // namespace
}  // namespace cleave::benchmarks
