// A judged quantity whose check cannot fail says nothing: each kind has a twin in the shipped cases, whose reference or method is wrong.
#include "validation/case.hpp"
#include "validation/suite.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace cleave::validation {
namespace {

/// "body" or a study, and what it measures: a quantity of one study says nothing about its namesake elsewhere.
using Kind = std::pair<std::string, std::string>;

struct Judged {
    std::map<Kind, std::set<std::string>> cases;  ///< names of the cases that judge it
    std::set<Kind> twins;
};

Judged judged_by(const std::vector<Case>& cases) {
    Judged judged;
    for (const Case& one : cases)
        for (const Check& check : one.checks) {
            if (check.bands.empty()) continue;
            const Kind kind{one.study_info ? one.study_info->name : "body", check.observable.quantity};
            if (check.must_fail)
                judged.twins.insert(kind);
            else
                judged.cases[kind].insert(one.name);
        }
    return judged;
}

std::vector<std::string> without_twin(const Judged& judged) {
    std::vector<std::string> missing;
    for (const auto& [kind, cases] : judged.cases)
        if (!judged.twins.count(kind)) missing.push_back(fmt::format("{} of {}, judged in {}", kind.second, kind.first, fmt::join(cases, ", ")));
    return missing;
}

std::vector<Case> shipped() {
    std::vector<Case> all;
    for (const auto& file : shipped_case_files())
        for (Case& one : read_cases(file.string(), {})) all.push_back(std::move(one));
    return all;
}

TEST(Twins, EveryJudgedQuantityOfTheShippedCasesHasOne) {
    const Judged judged = judged_by(shipped());
    EXPECT_GT(judged.cases.size(), 50U);
    for (const std::string& missing : without_twin(judged)) ADD_FAILURE() << missing << ": no check with must_fail = true";
}

// The must-fail twin of this test: with a twin taken away it is missed.
TEST(Twins, AQuantityThatLosesItsTwinIsNamed) {
    Judged judged = judged_by(shipped());
    judged.twins.erase({"fem_indentation", "depth"});
    EXPECT_EQ(without_twin(judged), std::vector<std::string>{"depth of fem_indentation, judged in indentation_hertz"});
}

}  // namespace
}  // namespace cleave::validation
