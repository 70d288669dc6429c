#include "reports/history.hpp"

#include <fmt/format.h>

#include <map>

namespace cleave::reports {

using nlohmann::json;

namespace {

struct Seen {
    std::string of_case, what;
    json error, verdict;
};
using Rows = std::map<std::string, Seen>;

std::string text(const json& row, const char* key) {
    const auto it = row.find(key);
    return it != row.end() && it->is_string() ? it->get<std::string>() : "";
}

void add_rows(const json& results, Rows& rows) {
    for (const json& entry : results["cases"])
        for (const json& row : entry["checks"]) {
            const bool twin = row.value("must_fail", json(false)) == json(true);
            const std::string component = text(row, "component"), gap = component.empty() ? "" : " ";
            const std::string what = fmt::format("{}{}{} by {}, {}{}", text(row, "quantity"), gap, component, text(row, "solver"), text(row, "place"),
                                                 twin ? " (must fail)" : "");
            const std::string name = text(entry, "name");
            rows[fmt::format("{} | {} | {}", name, what, text(row, "reference_source"))] = {name, what, row.value("error", json()), row["verdict"]};
        }
}

json short_of(const std::string& folder, const json& results, const json& provenance) {
    json counts = {{"pass", 0}, {"fail", 0}, {"info", 0}};
    for (const json& entry : results["cases"])
        for (const json& row : entry["checks"]) counts[row["verdict"].get<std::string>()] = counts[row["verdict"].get<std::string>()].get<int>() + 1;
    return {{"folder", folder},
            {"level", results.value("level", json())},
            {"commit", provenance.is_object() ? text(provenance, "commit") : ""},
            {"counts", counts},
            {"headline", results.value("headline", json())}};
}

json change(const char* kind, const Seen& row, const json& before, const json& now, const json& verdict_before, const json& verdict_now) {
    return {{"kind", kind}, {"case", row.of_case}, {"what", row.what}, {"before", before}, {"now", now}, {"verdict_before", verdict_before}, {"verdict_now", verdict_now}};
}

json changes_between(const Rows& before, const Rows& now) {
    json changes = json::array();
    for (const auto& [key, row] : now) {
        const auto old = before.find(key);
        if (old == before.end())
            changes.push_back(change("new", row, nullptr, row.error, nullptr, row.verdict));
        else if (old->second.error != row.error || old->second.verdict != row.verdict)
            changes.push_back(change("drifted", row, old->second.error, row.error, old->second.verdict, row.verdict));
    }
    for (const auto& [key, row] : before)
        if (!now.contains(key)) changes.push_back(change("vanished", row, row.error, nullptr, row.verdict, nullptr));
    return changes;
}

}  // namespace

json read_history(const std::vector<std::filesystem::path>& folders, const Report& report) {
    if (folders.empty()) return nullptr;
    json runs = json::array();
    Rows before, now;
    for (const std::filesystem::path& folder : folders) {
        const Report earlier = load_report({folder});
        const ReportSource& source = earlier.sources.front();
        runs.push_back(short_of(source.folder, source.results, source.provenance));
        before.clear();
        add_rows(source.results, before);
    }
    for (const ReportSource& source : report.sources) {
        runs.push_back(short_of(source.folder, source.results, source.provenance));
        add_rows(source.results, now);
    }
    return {{"runs", runs}, {"changes", changes_between(before, now)}};
}

}  // namespace cleave::reports
