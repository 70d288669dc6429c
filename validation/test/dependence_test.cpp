// The direction of dependence between the folders, read off the include lines of the sources.

#include "solver/input/file_io.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace cleave {
namespace {

namespace fs = std::filesystem;

const fs::path root = CLEAVE_SOURCE_FOLDER;

struct Include {
    std::string file, target;
};

std::vector<Include> includes_in(const std::string& text, const std::string& file) {
    static const std::regex pattern(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])", std::regex::multiline);
    std::vector<Include> found;
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) found.push_back({file, (*it)[1]});
    return found;
}

std::vector<Include> includes_below(const std::string& folder) {
    std::vector<Include> all;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string extension = entry.path().extension();
        if (extension != ".cpp" && extension != ".hpp") continue;
        for (Include& one : includes_in(read_file(entry.path()), fs::relative(entry.path(), root).string())) all.push_back(std::move(one));
    }
    return all;
}

bool starts_with_any(const std::string& text, const std::vector<std::string>& heads) {
    for (const std::string& head : heads)
        if (text.rfind(head, 0) == 0) return true;
    return false;
}

std::string violations(const std::vector<Include>& includes, const std::vector<std::string>& forbidden) {
    std::string text;
    for (const Include& one : includes)
        if (starts_with_any(one.target, forbidden)) text += one.file + " includes " + one.target + "\n";
    return text;
}

TEST(Dependence, TheSolverKnowsNeitherTheFemNorTheHarness) {
    EXPECT_EQ(violations(includes_below("solver"), {"reference_fem/", "validation/", "benchmarks/", "reports/", "deal.II/"}), "");
}

TEST(Dependence, TheFemSharesNoCodeWithTheSolver) {
    EXPECT_EQ(violations(includes_below("reference_fem"), {"solver/", "validation/", "benchmarks/", "reports/"}), "");
}

TEST(Dependence, AnalyticSolutionsStandAlone) {
    EXPECT_EQ(violations(includes_below("validation/analytic"), {"solver/", "reference_fem/", "validation/adapters", "deal.II/", "Eigen/"}), "");
}

TEST(Dependence, DealIIStaysInsideTheReference) {
    for (const char* folder : {"validation", "benchmarks", "reports"}) EXPECT_EQ(violations(includes_below(folder), {"deal.II/"}), "");
    for (const auto& entry : fs::directory_iterator(root / "reference_fem")) {  // nor through its public headers
        const std::string name = entry.path().filename();
        if (!std::set<std::string>{"contact.hpp", "distributed.hpp", "elasticity.hpp", "problem.hpp", "solution.hpp", "vtu.hpp"}.count(name)) continue;
        EXPECT_EQ(violations(includes_in(read_file(entry.path()), name), {"deal.II/", "Eigen/"}), "");
    }
}

/// deal.II's CMake macros turn RelWithDebInfo into Debug and hand their flags on to whoever links: none of them is called (trap 8).
TEST(Dependence, DealIIsMacrosAreNotCalled) {
    int read = 0;
    for (const char* folder : {"solver", "reference_fem", "validation", "benchmarks", "reports"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (entry.path().filename() != "CMakeLists.txt" && entry.path().extension() != ".cmake") continue;
            ++read;
            const std::string text = read_file(entry.path());
            for (const char* macro : {"deal_ii_setup_target(", "deal_ii_initialize_cached_variables("})
                EXPECT_EQ(text.find(macro), std::string::npos) << entry.path() << " calls " << macro;
        }
    EXPECT_GT(read, 5);
}

/// Lines of a test that make their own name below the temporary folder: run beside others, two tests meet there.
std::string own_temporary_names(const std::string& text, const std::string& file) {
    std::string found;
    for (const char* call : {"TempDir()", "temp_directory_path()"})
        if (text.find(call) != std::string::npos) found += file + " calls " + call + "\n";
    return found;
}

TEST(Dependence, TestsWriteInScratchFolders) {
    EXPECT_EQ(own_temporary_names("path = testing::TempDir() + name", "a.cpp"), "a.cpp calls TempDir()\n");
    for (const char* folder : {"solver", "validation", "benchmarks", "reports"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string name = entry.path().filename();
            if (!name.ends_with("_test.cpp") || name == "dependence_test.cpp") continue;
            EXPECT_EQ(own_temporary_names(read_file(entry.path()), fs::relative(entry.path(), root).string()), "") << "expected a ScratchFolder";
        }
}

TEST(Dependence, ReportsReadFilesOnly) {
    EXPECT_EQ(violations(includes_below("reports"), {"validation/", "reference_fem/", "benchmarks/", "solver/material", "solver/mesh",
                                                     "solver/particles", "solver/elasticity", "solver/subdivision"}), "");
}

TEST(Dependence, SolverFoldersUseOnlyThoseBeforeThem) {
    const std::vector<std::string> order{"input", "parallel", "material", "mesh", "particles", "elasticity", "contact", "fracture", "subdivision",
                                         "fragments", "rigid", "simulation"};
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (!fs::exists(root / "solver" / order[i])) continue;
        std::vector<std::string> later;
        for (std::size_t j = i + 1; j < order.size(); ++j) later.push_back("solver/" + order[j] + "/");
        EXPECT_EQ(violations(includes_below("solver/" + order[i]), later), "");
    }
}

TEST(Dependence, AnIncludeAgainstTheDirectionIsSeen) {
    const std::string text = "#pragma once\n  #  include \"validation/case.hpp\"\n#include <deal.II/fe/fe.h>\n";
    EXPECT_EQ(violations(includes_in(text, "a.hpp"), {"validation/", "deal.II/"}), "a.hpp includes validation/case.hpp\na.hpp includes deal.II/fe/fe.h\n");
}

TEST(Dependence, TheTopLevelHoldsWhatTheLayoutSays) {
    const std::set<std::string> allowed{"CMakeLists.txt", "solver", "reference_fem", "validation", "benchmarks", "reports", "README.md", "cleave",
                                        "CMakePresets.json", "LICENSE", "CITATION.cff", "CHANGELOG.md", "build", "out"};
    for (const auto& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename();
        EXPECT_TRUE(name.front() == '.' || allowed.count(name)) << name;
    }
}

}  // namespace
}  // namespace cleave
