#include "reports/results_check.hpp"

#include "solver/input/input_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using cleave::InputError;
using cleave::reports::check_results;
using nlohmann::json;

json good() {
    return json::parse(R"({"schema": "cleave.results/1",
        "level": "quick", "counts": {"pass": 1, "fail": 0, "info": 0}, "cases": [{"name": "a", "tier": "verification", "checks": [
        {"quantity": "stress", "solver": "fem.p2", "value": 1.0, "reference": null, "error": 0.1, "band": {"relative": 0.2},
         "ladder": [{"size": 0.1, "error": 1e-3}], "artifacts": [{"file": "a.csv"}], "must_fail": false, "verdict": "pass"}]}]})");
}

std::string key_of_failure(const json& results) {
    try {
        check_results(results, "results.json");
    } catch (const InputError& error) {
        return error.key();
    }
    return "accepted";
}

TEST(ResultsCheck, AcceptsAWholeDocument) { EXPECT_EQ(key_of_failure(good()), "accepted"); }

TEST(ResultsCheck, AcceptsUnknownKeys) {
    json results = good();
    results["cases"][0]["checks"][0]["colour"] = "blue";
    EXPECT_EQ(key_of_failure(results), "accepted");
}

struct Damage {
    const char* pointer;
    json value;
    const char* key;  ///< that the message must name
};

/// Test names come from the pointer: stable from run to run.
std::string test_name(const testing::TestParamInfo<Damage>& info) {
    std::string name = info.param.pointer;
    std::replace(name.begin(), name.end(), '/', '_');
    return name.substr(1) + "_" + std::to_string(info.index);
}

void PrintTo(const Damage& damage, std::ostream* stream) { *stream << damage.pointer << " = " << damage.value; }

class ResultsCheckRejects : public testing::TestWithParam<Damage> {};

TEST_P(ResultsCheckRejects, NamesTheKey) {
    json results = good();
    results[json::json_pointer(GetParam().pointer)] = GetParam().value;
    EXPECT_EQ(key_of_failure(results), GetParam().key);
}

INSTANTIATE_TEST_SUITE_P(Damages, ResultsCheckRejects, testing::Values(
    Damage{"/schema", "cleave.results/2", "schema"}, Damage{"/schema", 1, "schema"}, Damage{"/level", 3, "level"},
    Damage{"/counts/pass", 2, "counts.pass"}, Damage{"/counts", json::array(), "counts.pass"},
    Damage{"/cases", json::object(), "cases"}, Damage{"/cases/0", 7, "cases[0]"}, Damage{"/cases/0/name", nullptr, "cases[0].name"},
    Damage{"/cases/0/checks", nullptr, "cases[0].checks"},
    Damage{"/cases/0/checks/0/verdict", "maybe", "cases[0].checks[0].verdict"},
    Damage{"/cases/0/checks/0/value", "1.0", "cases[0].checks[0].value"},
    Damage{"/cases/0/checks/0/band", 0.2, "cases[0].checks[0].band"},
    Damage{"/cases/0/checks/0/must_fail", "no", "cases[0].checks[0].must_fail"},
    Damage{"/cases/0/checks/0/ladder/0/size", nullptr, "cases[0].checks[0].ladder[0].size"},
    Damage{"/cases/0/checks/0/artifacts/0/file", 1, "cases[0].checks[0].artifacts[0].file"}),
    test_name);

}  // namespace
