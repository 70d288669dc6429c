#include "solver/input/table_reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace cleave::validation {
namespace {

namespace fs = std::filesystem;

const fs::path root = CLEAVE_SOURCE_FOLDER;

struct Entry {
    std::string id, what, status, note;
    std::vector<std::string> code, tests, cases;
};

std::vector<Entry> read_ledger(const std::string& file) {
    TableReader reader = TableReader::from_file(file);
    std::vector<Entry> entries;
    for (TableReader& table : reader.tables("entry")) {
        Entry entry{table.string("id"), table.string("what"),
                    table.choice("status", {"as_printed", "corrected", "measured", "contradiction", "open"}), table.string("note"),
                    table.strings("code"), table.strings("tests"), table.strings("cases")};
        entries.push_back(std::move(entry));
    }
    reader.finish();
    return entries;
}

/// What is wrong with an entry: files and cases that are not there, a status without what it needs.
std::vector<std::string> faults(const Entry& entry) {
    std::vector<std::string> found;
    const auto need = [&](const fs::path& path) {
        if (!fs::exists(root / path)) found.push_back(fmt::format("{}: {} is not there", entry.id, path.string()));
    };
    for (const std::string& file : entry.code) need(file);
    for (const std::string& file : entry.tests) need(file);
    for (const std::string& name : entry.cases) need(fs::path("validation/cases") / (name + ".toml"));
    if (entry.code.empty()) found.push_back(entry.id + ": no code");
    const bool covered = !entry.tests.empty() || !entry.cases.empty();
    if (!covered && entry.note.empty()) found.push_back(entry.id + ": neither test nor case, and no note");
    if (entry.status == "as_printed" && !covered) found.push_back(entry.id + ": no test");
    if ((entry.status == "corrected" || entry.status == "contradiction" || entry.status == "open") && entry.note.empty())
        found.push_back(fmt::format("{}: {} without a note", entry.id, entry.status));
    return found;
}

TEST(PaperLedger, EveryFileAndCaseIsThere) {
    for (const Entry& entry : read_ledger((root / "validation/paper_ledger.toml").string()))
        for (const std::string& fault : faults(entry)) ADD_FAILURE() << fault;
}

TEST(PaperLedger, NothingOfThePaperIsMissing) {
    std::multiset<std::string> ids;
    for (const Entry& entry : read_ledger((root / "validation/paper_ledger.toml").string())) ids.insert(entry.id);
    std::vector<std::string> wanted{"algorithm_1", "algorithm_2", "table_1", "table_2", "u_limit", "hooke", "particle_radius", "layers", "hybrid_materials"};
    for (int i = 1; i <= 11; ++i) wanted.push_back(fmt::format("eq_{}", i));
    for (int i = 1; i <= 12; ++i) wanted.push_back(fmt::format("fig_{}", i));
    for (const std::string& id : wanted) EXPECT_EQ(ids.count(id), 1U) << id;
    const auto claims = std::count_if(ids.begin(), ids.end(), [](const std::string& id) { return id.starts_with("claim_"); });
    EXPECT_GE(claims, 5);
}

// The must-fail twin: each kind of fault is found.
TEST(PaperLedger, FaultsAreFound) {
    const Entry good{"eq_1", "strain", "corrected", "why", {"README.md"}, {"README.md"}, {"patch_triclinic"}};
    EXPECT_TRUE(faults(good).empty());
    Entry bad = good;
    bad.code = {"solver/no_such_file.hpp"};
    EXPECT_EQ(faults(bad).size(), 1U);
    bad = good;
    bad.cases = {"no_such_case"};
    EXPECT_EQ(faults(bad).size(), 1U);
    bad = good;
    bad.note = "";
    EXPECT_EQ(faults(bad).size(), 1U);
    bad = good;
    bad.status = "as_printed";
    bad.tests.clear();
    bad.cases.clear();
    EXPECT_EQ(faults(bad).size(), 1U);
}

}  // namespace
}  // namespace cleave::validation
